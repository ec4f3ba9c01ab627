#include "cli/options/value_types.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <tuple>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/options/parse_value.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/labels/time_ticks.h"
#include "core/scene/theme.h"
#include "core/scene/transfer_function.h"
#include "core/store/scalar_picture.h"

namespace vvr::options {

namespace {

constexpr Range azimuths{-360, 360};
constexpr Range elevations{-90, 90};

/// Words for --start-time.
constexpr std::pair<std::string_view, app::StartTime::From> clock_words[] = {
    {"recorded", app::StartTime::From::recorded},
    {"container", app::StartTime::From::container},
    {"modified", app::StartTime::From::modified},
    {"none", app::StartTime::From::none}};

}  // namespace

// ---- Numbers

void set_value(const Setting& setting, const std::string& text, double& value) {
    const bool ranged = setting.range.low < setting.range.high;
    if (setting.unit != "TIME") {
        value = parse_number(text, setting.range);
    } else {
        value = ranged ? parse_duration(text, setting.range) : parse_duration(text);
    }
}

std::string value_text(const Setting& setting, double value) {
    return fmt::format("{}{}", value, setting.unit == "TIME" ? "s" : "");
}

void set_value(const Setting& setting, const std::string& text, int& value) {
    value = static_cast<int>(parse_integer(text, static_cast<std::int64_t>(setting.range.low),
                                           static_cast<std::int64_t>(setting.range.high)));
}

std::string value_text(const Setting& /*setting*/, int value) {
    return fmt::to_string(value);
}

void set_value(const Setting& setting, const std::string& text, std::int64_t& value) {
    value = setting.unit == "BYTES" ? parse_bytes(text)
                                    : parse_integer(text, static_cast<std::int64_t>(setting.range.low),
                                                    static_cast<std::int64_t>(setting.range.high));
}

std::string value_text(const Setting& /*setting*/, std::int64_t value) {
    return fmt::to_string(value);
}

std::string value_text(const Setting& /*setting*/, bool value) {
    return value ? "true" : "";
}

/// A factor on all limits.
void set_value(const Setting& setting, const std::string& text, image::Tolerance& value) {
    const double factor = parse_number(text, setting.range);
    const image::Tolerance limits;
    value = {factor * limits.level, factor * limits.percent, factor * limits.patch};
}

std::string value_text(const Setting& /*setting*/, const image::Tolerance& value) {
    return fmt::to_string(value.level / image::Tolerance{}.level);
}

void set_value(const Setting& /*setting*/, const std::string& text, std::pair<int, int>& share) {
    share = parse_share(text);
}

std::string value_text(const Setting& /*setting*/, const std::pair<int, int>& share) {
    return fmt::format("{}/{}", share.first, share.second);
}

// ---- Text

void set_value(const Setting& /*setting*/, const std::string& text, std::string& value) {
    value = text;
}

std::string value_text(const Setting& /*setting*/, const std::string& value) {
    return value;
}

std::string value_text(const Setting& /*setting*/, const std::vector<std::string>& values) {
    return fmt::format("{}", fmt::join(values, " "));
}

void set_value(const Setting& /*setting*/, const std::string& text, std::filesystem::path& value) {
    value = text;
}

std::string value_text(const Setting& /*setting*/, const std::filesystem::path& value) {
    return value.string();
}

void set_value(const Setting& /*setting*/, const std::string& text,
               const fields::FieldFolder<fields::FieldOptions>& value) {
    value.options.given_folder = text;
    value.options.read_given = store::read_scalar;
    value.options.filter = "given";
}

std::string value_text(const Setting& /*setting*/, const fields::FieldFolder<const fields::FieldOptions>& value) {
    return value.options.given_folder;
}

// ---- Times

void set_value(const Setting& /*setting*/, const std::string& text, std::chrono::seconds& value) {
    value = parse_whole_seconds(text);
}

std::string value_text(const Setting& /*setting*/, std::chrono::seconds value) {
    constexpr std::pair<std::int64_t, char> units[] = {{3600, 'h'}, {60, 'm'}, {1, 's'}};
    const std::int64_t seconds = value.count();
    const auto* const unit =
        std::ranges::find_if(units, [&](const auto& one) { return seconds != 0 && seconds % one.first == 0; });
    return unit == std::end(units) ? "0s" : fmt::format("{}{}", seconds / unit->first, unit->second);
}

void set_value(const Setting& /*setting*/, const std::string& text, app::Time& value) {
    value = parse_time(text);
}

std::string value_text(const Setting& /*setting*/, const app::Time& value) {
    return fmt::format("{}{}", value.value, value.unit == app::Time::Unit::seconds ? "s" : "f");
}

void set_value(const Setting& /*setting*/, const std::string& text, video::DayPart& value) {
    value = parse_day_part(text);
}

std::string value_text(const Setting& /*setting*/, const video::DayPart& value) {
    return value.text;
}

void set_value(const Setting& /*setting*/, const std::string& text, archive::DayRule& value) {
    value.begins = parse_minute_of_day(text);
}

std::string value_text(const Setting& /*setting*/, const archive::DayRule& value) {
    return fmt::format("{:02}:{:02}", value.begins.count() / 60, value.begins.count() % 60);
}

void set_value(const Setting& /*setting*/, const std::string& text, const app::SpanStart<video::FrameSpan>& value) {
    const auto place = parse_place(text);
    video::FrameSpan& span = value.span;
    span.start = 0;
    span.first = 0;
    span.asked.start.reset();
    if (const auto* const asked = std::get_if<video::RequestedTime>(&place)) {
        span.asked.start = *asked;
    } else if (const auto& time = std::get<app::Time>(place); time.unit == app::Time::Unit::seconds) {
        span.start = time.value;
    } else {
        span.first = static_cast<std::int64_t>(time.value);
    }
}

std::string value_text(const Setting& /*setting*/, const app::SpanStart<const video::FrameSpan>& value) {
    if (value.span.asked.start) return value.span.asked.start->text;
    return value.span.first > 0 ? fmt::format("{}f", value.span.first) : fmt::format("{}s", value.span.start);
}

void set_value(const Setting& /*setting*/, const std::string& text, const app::SpanEnd<video::FrameSpan>& value) {
    const auto place = parse_place(text);
    video::FrameSpan& span = value.span;
    span.end.reset();
    span.stop.reset();
    span.asked.end.reset();
    if (const auto* const asked = std::get_if<video::RequestedTime>(&place)) {
        span.asked.end = *asked;
    } else if (const auto& time = std::get<app::Time>(place); time.unit == app::Time::Unit::seconds) {
        span.end = time.value;
    } else {
        span.stop = static_cast<std::int64_t>(time.value);
    }
}

std::string value_text(const Setting& /*setting*/, const app::SpanEnd<const video::FrameSpan>& value) {
    if (value.span.asked.end) return value.span.asked.end->text;
    if (value.span.end) return fmt::format("{}s", *value.span.end);
    return value.span.stop ? fmt::format("{}f", *value.span.stop) : std::string();
}

void set_value(const Setting& /*setting*/, const std::string& text, app::StartTime& value) {
    const auto* const word = std::ranges::find(clock_words, text, [](const auto& row) { return row.first; });
    if (word != std::end(clock_words)) {
        value = {word->second};
    } else if (const auto seconds = parse_date_time(text)) {
        value = {app::StartTime::From::given, *seconds};
    } else {
        throw Error(ErrorCode::option_value,
                    fmt::format("'{}' is not a date and time like 2026-11-21 08:00:00, nor 'recorded', 'container', "
                                "'modified' or 'none'. To begin later in the clip, use --start",
                                text));
    }
}

std::string value_text(const Setting& /*setting*/, const app::StartTime& value) {
    if (value.from == app::StartTime::From::given) return labels::format_clock(value.clock->begin);
    const auto* const word = std::ranges::find(clock_words, value.from, [](const auto& row) { return row.second; });
    return word == std::end(clock_words) ? std::string() : std::string(word->first);
}

// ---- Sizes and places

void set_value(const Setting& /*setting*/, const std::string& text, Size& value) {
    value = parse_size(text);
}

std::string value_text(const Setting& /*setting*/, Size value) {
    return fmt::format("{}x{}", value.width, value.height);
}

void set_value(const Setting& /*setting*/, const std::string& text, const app::FieldSize<Size>& value) {
    value.value = text == "source" ? Size{-1, -1} : parse_size(text);
}

std::string value_text(const Setting& setting, const app::FieldSize<const Size>& value) {
    if (value.value.width == 0) return {};
    return value.value.width < 0 ? "source" : value_text(setting, value.value);
}

void set_value(const Setting& /*setting*/, const std::string& text, video::Aspect& value) {
    const auto [width, height] = parse_pair(text, ':', {1, 10'000}, {1, 10'000});
    value = {static_cast<int>(width), static_cast<int>(height)};
}

std::string value_text(const Setting& /*setting*/, const video::Aspect& value) {
    return fmt::format("{}:{}", value.width, value.height);
}

void set_value(const Setting& /*setting*/, const std::string& text, space::View& direction) {
    std::tie(direction.azimuth, direction.elevation) = parse_pair(text, ',', azimuths, elevations);
}

std::string value_text(const Setting& /*setting*/, const space::View& direction) {
    return fmt::format("{},{}", direction.azimuth, direction.elevation);
}

void set_value(const Setting& setting, const std::string& text, const app::Radii<space::LayoutOptions>& value) {
    const auto [inner, outer] = parse_pair(text, ':', setting.range, setting.range);
    if (inner >= outer) {
        throw Error(ErrorCode::option_value,
                    fmt::format("'{}': the outer radius must be greater than the inner one", text));
    }
    std::tie(value.shape.r_min, value.shape.r_max) = std::tie(inner, outer);
}

std::string value_text(const Setting& /*setting*/, const app::Radii<const space::LayoutOptions>& value) {
    return fmt::format("{}:{}", value.shape.r_min, value.shape.r_max);
}

// ---- Colours

void set_value(const Setting& /*setting*/, const std::string& text, glm::vec4& colour) {
    unsigned value = 0;
    const char* const end = text.data() + text.size();
    const bool hex = text.size() == 7 && text[0] == '#' && std::from_chars(text.data() + 1, end, value, 16).ptr == end;
    if (!hex && text != "none")
        throw Error(ErrorCode::option_value, fmt::format("'{}' is not a colour like #rrggbb, nor 'none'", text));
    // Premultiplied with the opacity.
    colour = !hex ? glm::vec4(0)
                  : glm::vec4(static_cast<float>(value >> 16 & 255U) / 255, static_cast<float>(value >> 8 & 255U) / 255,
                              static_cast<float>(value & 255U) / 255, 1);
}

std::string value_text(const Setting& /*setting*/, const glm::vec4& colour) {
    if (colour.a == 0) return "none";
    const auto level = [](float value) { return std::lround(value * 255); };
    return fmt::format("#{:02x}{:02x}{:02x}", level(colour.r), level(colour.g), level(colour.b));
}

void set_value(const Setting& /*setting*/, const std::string& text, std::optional<app::NamedTransfer>& value) {
    value = app::NamedTransfer{text, scene::find_transfer(text)};
}

std::string value_text(const Setting& /*setting*/, const app::NamedTransfer& value) {
    return value.name;
}

/// The transfer functions of the themes, and of the filters that have their own.
OptionExtra help_of_values(const std::optional<app::NamedTransfer>& /*value*/) {
    std::string defaults =
        defaults_of(scene::themes(), [](const scene::Theme& theme) { return std::string(theme.transfer); });
    for (const fields::FilterRow& filter : fields::filters()) {
        if (!filter.transfer.empty()) defaults += fmt::format("; {}: {}", filter.name, filter.transfer);
    }
    return {.help = ", or a file of points", .values = values_of(scene::transfer_functions()), .defaults = defaults};
}

// ---- Sets and selections

void set_value(const Setting& setting, const std::string& text, app::Parts& value) {
    value = {};
    for (const std::string& word : split_list(text)) value.add(choose(setting.name, word, app::parts()).part);
}

std::string value_text(const Setting& /*setting*/, const app::Parts& value) {
    std::vector<std::string_view> names;
    for (const app::PartRow& row : app::parts()) {
        if (value.has(row.part)) names.push_back(row.name);
    }
    return fmt::format("{}", fmt::join(names, ","));
}

OptionExtra help_of_values(const app::Parts& /*value*/) {
    return {.values = values_of(app::parts())};
}

/// A length among the kinds is the least one of an event; alone, it is that of all kinds.
void set_value(const Setting& setting, const std::string& text, events::EventChoice& value) {
    constexpr Range lengths{0, 86'400};
    value = {.kinds = {}, .least = 0};
    bool only_length = false;
    for (const std::string& word : split_list(text)) {
        if (!word.empty() && word[0] >= '0' && word[0] <= '9') {
            value.least = parse_duration(word, lengths);
            only_length = value.kinds.empty();
        } else {
            value.kinds.insert(choose(setting.name, word, events::event_kinds, ", or a length like 5s").kind);
        }
    }
    if (only_length && value.kinds.empty()) value.kinds = events::all_kinds();
}

std::string value_text(const Setting& /*setting*/, const events::EventChoice& value) {
    return names_in(value.kinds, events::event_kinds, &events::EventKindRow::kind) +
           (value.least > 0 ? fmt::format(",{}s", value.least) : "");
}

OptionExtra help_of_values(const events::EventChoice& /*value*/) {
    return {.values = values_of(events::event_kinds)};
}

// ---- OpenGL

void set_value(const Setting& setting, const std::string& text,
               const app::BackendAndDevice<app::BackendOptions>& value) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const gl::Backend& row = choose(setting.name, text.substr(0, colon), gl::backends());
    value.backend.device = -1;
    if (colon < text.size()) {
        if (row.devices == nullptr) {
            throw Error(
                ErrorCode::option_value,
                fmt::format("'{}': a device is one of a backend; name it, as in egl:{}", text, text.substr(colon + 1)));
        }
        value.backend.device = static_cast<int>(parse_integer(text.substr(colon + 1), 0, 255));
    }
    value.backend.row = row;
}

std::string value_text(const Setting& /*setting*/, const app::BackendAndDevice<app::BackendOptions>& value) {
    const std::string& name = value.backend.row->name;
    return value.backend.device < 0 ? name : fmt::format("{}:{}", name, value.backend.device);
}

OptionExtra help_of_values(const app::BackendAndDevice<app::BackendOptions>& /*value*/) {
    return {.values = values_of(gl::backends())};
}

void set_value(const Setting& /*setting*/, const std::string& text, fields::SeedSelection& value) {
    value = fields::parse_seed_selection(text);
}

std::string value_text(const Setting& /*setting*/, const fields::SeedSelection& value) {
    using Kind = fields::SeedSelection::Kind;
    if (value.kind == Kind::all) return "all";
    if (value.kind == Kind::first) return fmt::format("first:{}", value.count);
    return fmt::format("random:{}:{}", value.count, value.number);
}

void set_value(const Setting& /*setting*/, const std::string& text, fields::SeedFlags& value) {
    const auto flags = fields::SeedFlags::parse(text);
    if (!flags) {
        throw Error(ErrorCode::option_value,
                    fmt::format("'{}' is not 1 to {} digits 0 or 1, one per brick", text, fields::SeedFlags::most));
    }
    value = *flags;
}

std::string value_text(const Setting& /*setting*/, const fields::SeedFlags& value) {
    return value.text();
}

}  // namespace vvr::options
