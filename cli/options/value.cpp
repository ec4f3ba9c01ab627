#include "cli/options/value.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <tuple>
#include <type_traits>
#include <variant>

#include "core/annotation/time_ticks.h"
#include "core/base/error.h"
#include "core/scene/theme.h"
#include "core/scene/transfer_function.h"

namespace vvr::options {

namespace {

constexpr std::array true_words{"true", "yes", "on", "enable", "t", "y", "1", "+"};
constexpr std::array false_words{"false", "no", "off", "disable", "f", "n", "0", "-"};

/// A word for --start-time.
struct ClockWord {
    std::string_view name;
    app::StartTime::From from;
};
constexpr std::array clock_words{
    ClockWord{"recorded", app::StartTime::From::recorded}, ClockWord{"container", app::StartTime::From::container},
    ClockWord{"modified", app::StartTime::From::modified}, ClockWord{"none", app::StartTime::From::none}};

template <class Number>
Number parse_as(const Setting& setting, const std::string& text) {
    const auto [low, high] = setting.range;
    if constexpr (std::is_integral_v<Number>) {
        if (setting.unit == "BYTES") return static_cast<Number>(parse_bytes(text));
        return static_cast<Number>(
            parse_integer(text, static_cast<std::int64_t>(low), static_cast<std::int64_t>(high)));
    } else {
        if (setting.unit == "FPS") return parse_rate(text, setting.range);
        if (setting.unit != "TIME") return parse_number(text, setting.range);
        return low < high ? parse_duration(text, setting.range) : parse_duration(text);
    }
}

/// \param parse makes the value of a text
/// \param print the opposite
template <class Variable, class Parse, class Print>
Value bound(Variable& variable, Parse parse, Print print) {
    return {[&variable, parse](const std::string& text) { variable = parse(text); },
            [&variable, print] { return std::string(print(std::as_const(variable))); }};
}

template <class Number>
Value value_of_number(const Setting& setting, Number& number, const std::optional<app::Word>& zero = {}) {
    const auto parse = [setting, zero](const std::string& text) {
        return zero && !text.empty() && text == zero->text ? Number{} : parse_as<Number>(setting, text);
    };
    return bound(number, parse, [setting, zero](Number value) {
        return zero && value == 0 ? std::string(zero->text)
                                  : fmt::format("{}{}", value, setting.unit == "TIME" ? "s" : "");
    });
}

bool parse_bool(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char letter) { return std::tolower(letter); });
    if (std::ranges::find(true_words, text) != true_words.end()) return true;
    if (std::ranges::find(false_words, text) != false_words.end()) return false;
    throw Error(ErrorCode::option_value, fmt::format("'{}' is not true or false", text));
}

/// `#rrggbb`, premultiplied with the opacity; `none` is transparent.
glm::vec4 parse_colour(const std::string& text) {
    unsigned value = 0;
    const char* const end = text.data() + text.size();
    if (text == "none") return glm::vec4(0);
    if (text.size() != 7 || text[0] != '#' || std::from_chars(text.data() + 1, end, value, 16).ptr != end)
        throw Error(ErrorCode::option_value, fmt::format("'{}' is not a colour like #rrggbb, nor 'none'", text));
    return {static_cast<float>(value >> 16 & 255U) / 255, static_cast<float>(value >> 8 & 255U) / 255,
            static_cast<float>(value & 255U) / 255, 1};
}

app::StartTime parse_start_time(const std::string& text) {
    const auto* const word = std::ranges::find(clock_words, text, &ClockWord::name);
    if (word != clock_words.end()) return {word->from};
    if (const auto seconds = parse_date_time(text)) return {app::StartTime::From::given, *seconds};
    throw Error(ErrorCode::option_value,
                fmt::format("'{}' is not a date and time like 2026-11-21 08:00:00, nor 'recorded', 'container', "
                            "'modified' or 'none'. To begin later in the clip, use --start",
                            text));
}

/// Sets one end of a span, in whichever way it is given.
template <class Seconds, class Frame>
void set_end(const std::string& text, Seconds& seconds, Frame& frame, std::optional<media::RequestedTime>& asked) {
    const auto place = parse_place(text);
    seconds = {};
    frame = {};
    asked.reset();
    if (const auto* const clock = std::get_if<media::RequestedTime>(&place)) {
        asked = *clock;
    } else if (const auto& time = std::get<app::Time>(place); time.unit == app::Time::Unit::seconds) {
        seconds = time.value;
    } else {
        frame = static_cast<std::int64_t>(time.value);
    }
}

/// A length among the kinds is the least one of an event; alone, it is that of all kinds.
tracking::EventChoice parse_events(const Setting& setting, const std::string& text) {
    constexpr Range lengths{0, 86'400};
    tracking::EventChoice choice{.kinds = {}, .least = 0};
    bool only_length = false;
    for (const std::string& word : split_list(text)) {
        if (!word.empty() && word[0] >= '0' && word[0] <= '9') {
            choice.least = parse_duration(word, lengths);
            only_length = choice.kinds.empty();
        } else {
            choice.kinds.insert(choose(setting.name, word, tracking::event_kinds, ", or a length like 5s").kind);
        }
    }
    if (only_length && choice.kinds.empty()) choice.kinds = tracking::all_kinds();
    return choice;
}

/// `egl:1`: a backend, and the device that it opens.
void parse_backend(const Setting& setting, const std::string& text, app::BackendOptions& backend) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const gl::Backend& row = choose(setting.name, text.substr(0, colon), gl::backends());
    const std::string device = colon < text.size() ? text.substr(colon + 1) : "";
    if (colon < text.size() && row.devices == nullptr) {
        throw Error(ErrorCode::option_value,
                    fmt::format("'{}': a device is one of a backend; name it, as in egl:{}", text, device));
    }
    backend.device = colon < text.size() ? static_cast<int>(parse_integer(device, 0, 255)) : -1;
    backend.row = row;
}

fields::SeedFlags parse_seed_flags(const std::string& text) {
    const auto flags = fields::SeedFlags::parse(text);
    if (flags) return *flags;
    throw Error(ErrorCode::option_value,
                fmt::format("'{}' is not 1 to {} digits 0 or 1, one per brick", text, fields::SeedFlags::most));
}

app::Parts parse_parts(const Setting& setting, const std::string& text) {
    app::Parts parts;
    for (const std::string& word : split_list(text)) parts.add(choose(setting.name, word, app::parts()).part);
    return parts;
}

}  // namespace

// ---- Numbers

Value value_of(const Setting& /*setting*/, bool& flag) {
    Value value = bound(flag, parse_bool, [](bool is_set) { return is_set ? "true" : ""; });
    value.shape = Value::Shape::flag;
    return value;
}

Value value_of(const Setting& setting, double& number, const std::optional<app::Word>& zero) {
    return value_of_number(setting, number, zero);
}

Value value_of(const Setting& setting, int& number, const std::optional<app::Word>& zero) {
    return value_of_number(setting, number, zero);
}

Value value_of(const Setting& setting, std::int64_t& number) {
    return value_of_number(setting, number);
}

Value value_of(const Setting& setting, image::Tolerance& limits) {
    const auto parse = [setting](const std::string& text) {
        const double factor = parse_number(text, setting.range);
        const image::Tolerance one;
        return image::Tolerance{factor * one.level, factor * one.percent, factor * one.patch};
    };
    return bound(limits, parse,
                 [](const image::Tolerance& of) { return fmt::to_string(of.level / image::Tolerance{}.level); });
}

Value value_of(const Setting& /*setting*/, std::pair<int, int>& share) {
    return bound(share, parse_share, [](const auto& of) { return fmt::format("{}/{}", of.first, of.second); });
}

// ---- Text

Value value_of(const Setting& /*setting*/, std::string& text) {
    return bound(text, std::identity(), std::identity());
}

Value value_of(const Setting& /*setting*/, std::filesystem::path& path) {
    Value value = bound(path, std::identity(), [](const std::filesystem::path& of) { return of.string(); });
    value.is_path = true;
    return value;
}

Value value_of(const Setting& /*setting*/, std::vector<std::string>& texts) {
    return {.set = [&texts](const std::string& text) { texts.push_back(text); },
            .text = [&texts] { return fmt::format("{}", fmt::join(texts, " ")); },
            .shape = Value::Shape::list};
}

Value value_of(const Setting& /*setting*/, fields::SeedSelection& selection) {
    return bound(selection, fields::parse_seed_selection, [](const fields::SeedSelection& of) {
        using Kind = fields::SeedSelection::Kind;
        if (of.kind == Kind::all) return std::string("all");
        if (of.kind == Kind::first) return fmt::format("first:{}", of.count);
        return fmt::format("random:{}:{}", of.count, of.number);
    });
}

Value value_of(const Setting& /*setting*/, fields::SeedFlags& flags) {
    return bound(flags, parse_seed_flags, [](const fields::SeedFlags& of) { return of.text(); });
}

// ---- Times

Value value_of(const Setting& /*setting*/, std::chrono::seconds& length) {
    return bound(length, parse_whole_seconds, [](std::chrono::seconds of) {
        for (const auto& [size, letter] : {std::pair{3600, 'h'}, {60, 'm'}}) {
            if (of.count() != 0 && of.count() % size == 0) return fmt::format("{}{}", of.count() / size, letter);
        }
        return fmt::format("{}s", of.count());
    });
}

Value value_of(const Setting& /*setting*/, app::Time& time) {
    return bound(time, parse_time, [](const app::Time& of) {
        return fmt::format("{}{}", of.value, of.unit == app::Time::Unit::seconds ? "s" : "f");
    });
}

Value value_of(const Setting& /*setting*/, media::DayPart& part) {
    return bound(part, parse_day_part, [](const media::DayPart& of) { return of.text; });
}

Value value_of(const Setting& /*setting*/, archive::DayRule& rule) {
    return bound(rule.begins, parse_minute_of_day,
                 [](std::chrono::minutes of) { return fmt::format("{:02}:{:02}", of.count() / 60, of.count() % 60); });
}

Value value_of(const Setting& setting, media::FrameSpan& span) {
    if (setting.name == setting::end.name) {
        return {[&span](const std::string& text) { set_end(text, span.end, span.stop, span.asked.end); },
                [&span] {
                    if (span.asked.end) return span.asked.end->text;
                    if (span.end) return fmt::format("{}s", *span.end);
                    return span.stop ? fmt::format("{}f", *span.stop) : std::string();
                }};
    }
    return {[&span](const std::string& text) { set_end(text, span.start, span.first, span.asked.start); },
            [&span] {
                if (span.asked.start) return span.asked.start->text;
                return span.first > 0 ? fmt::format("{}f", span.first) : fmt::format("{}s", span.start);
            }};
}

Value value_of(const Setting& /*setting*/, app::StartTime& time) {
    return bound(time, parse_start_time, [](const app::StartTime& of) {
        if (of.from == app::StartTime::From::given) return annotation::format_clock(of.clock->begin);
        return names_where(clock_words, [&](const ClockWord& word) { return word.from == of.from; });
    });
}

// ---- Sizes, directions, colours

/// 0 means that none is given.
Value value_of(const Setting& /*setting*/, Size& size, app::Word below_zero) {
    const auto parse = [below_zero](const std::string& text) {
        return !text.empty() && text == below_zero.text ? Size{-1, -1} : parse_size(text);
    };
    return bound(size, parse, [below_zero](Size of) {
        if (of.width < 0) return std::string(below_zero.text);
        return of.width == 0 ? std::string() : fmt::format("{}x{}", of.width, of.height);
    });
}

Value value_of(const Setting& /*setting*/, media::Aspect& aspect) {
    return {[&aspect](const std::string& text) {
                const auto [width, height] = parse_pair(text, ':', {1, 10'000}, {1, 10'000});
                aspect = {static_cast<int>(width), static_cast<int>(height)};
            },
            [&aspect] { return fmt::format("{}:{}", aspect.width, aspect.height); }};
}

Value value_of(const Setting& /*setting*/, space::View& view) {
    return {[&view](const std::string& text) {
                std::tie(view.azimuth, view.elevation) = parse_pair(text, ',', {-360, 360}, {-90, 90});
            },
            [&view] { return fmt::format("{},{}", view.azimuth, view.elevation); }};
}

Value value_of(const Setting& setting, space::LayoutOptions& radii) {
    return {[setting, &radii](const std::string& text) {
                const auto [inner, outer] = parse_pair(text, ':', setting.range, setting.range);
                if (inner >= outer) {
                    throw Error(ErrorCode::option_value,
                                fmt::format("'{}': the outer radius must be greater than the inner one", text));
                }
                std::tie(radii.r_min, radii.r_max) = std::tie(inner, outer);
            },
            [&radii] { return fmt::format("{}:{}", radii.r_min, radii.r_max); }};
}

Value value_of(const Setting& /*setting*/, glm::vec4& colour) {
    return bound(colour, parse_colour, [](const glm::vec4& of) {
        const auto level = [](float value) { return std::lround(value * 255); };
        return of.a == 0 ? "none" : fmt::format("#{:02x}{:02x}{:02x}", level(of.r), level(of.g), level(of.b));
    });
}

// ---- Names of rows, with more

/// The defaults are the transfer functions of the themes, and of the filters that have their own.
Value value_of(const Setting& /*setting*/, std::optional<app::NamedTransfer>& transfer) {
    Value value = bound(
        transfer,
        [](const std::string& text) {
            return app::NamedTransfer{text, scene::find_transfer(text)};
        },
        [](const auto& of) { return of ? of->name : std::string(); });
    value.help = ", or a file of points";
    value.choices = values_of(scene::transfer_functions());
    value.defaults =
        defaults_of(scene::themes(), [](const scene::Theme& theme) { return std::string(theme.transfer); });
    for (const fields::FilterRow& filter : fields::filters()) {
        if (!filter.transfer.empty()) value.defaults += fmt::format("; {}: {}", filter.name, filter.transfer);
    }
    return value;
}

Value value_of(const Setting& setting, app::Parts& parts) {
    Value value = bound(
        parts, [setting](const std::string& text) { return parse_parts(setting, text); },
        [](const app::Parts& of) {
            return names_where(app::parts(), [&](const app::PartRow& row) { return of.has(row.part); });
        });
    value.choices = values_of(app::parts());
    return value;
}

Value value_of(const Setting& setting, tracking::EventChoice& choice) {
    Value value = bound(
        choice, [setting](const std::string& text) { return parse_events(setting, text); },
        [](const tracking::EventChoice& of) {
            return names_where(tracking::event_kinds, [&](const auto& row) { return of.kinds.contains(row.kind); }) +
                   (of.least > 0 ? fmt::format(",{}s", of.least) : "");
        });
    value.choices = values_of(tracking::event_kinds);
    return value;
}

Value value_of(const Setting& setting, app::BackendOptions& backend) {
    return {[setting, &backend](const std::string& text) { parse_backend(setting, text, backend); },
            [&backend] {
                const std::string& name = backend.row->name;
                return backend.device < 0 ? name : fmt::format("{}:{}", name, backend.device);
            },
            Value::Shape::one, "", values_of(gl::backends())};
}

}  // namespace vvr::options
