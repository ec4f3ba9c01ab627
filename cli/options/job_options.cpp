#include "cli/options/job_options.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <tuple>

#include "cli/app/settings.h"
#include "cli/options/parse_value.h"
#include "cli/options/presets.h"
#include "core/base/error.h"
#include "core/fields/settings.h"
#include "core/scene/transfer_function.h"
#include "core/video/recorder_names.h"

namespace vvr::options {

namespace {

/// Stores a time in the member of the span that has its unit.
void set_start(video::FrameSpan& span, const app::Time& time) {
    const bool seconds = time.unit == app::Time::Unit::seconds;
    span.start = seconds ? time.value : 0;
    span.first = seconds ? 0 : static_cast<std::int64_t>(time.value);
}

void set_end(video::FrameSpan& span, const app::Time& time) {
    if (time.unit == app::Time::Unit::seconds) {
        span.end = time.value;
    } else {
        span.stop = static_cast<std::int64_t>(time.value);
    }
}

/// Adds an option for a setting, according to the type of its value.
struct AddOption {
    CommandLine& line;
    Group group;

    template <class Number>
    void operator()(const Setting& setting, Number& target) const {
        line.number(group, target, setting);
    }
    template <class Number, class Rows, class Default>
    void operator()(const Setting& setting, Number& target, const Rows& rows, Default of_row) const {
        line.number(group, target, setting,
                    {.defaults = defaults_of(rows, [&](const auto& row) { return fmt::to_string(of_row(row)); })});
    }
    void operator()(const Setting& setting, std::string& target) const { line.text(group, target, setting); }
    void operator()(const Setting& setting, std::filesystem::path& target) const { line.path(group, target, setting); }
    void operator()(const Setting& setting, fields::SeedSelection& target) const {
        line.value(group, setting, "all",
                   [&target](const std::string& given) { target = fields::parse_seed_selection(given); });
    }
    template <class Row, class Rows>
    void operator()(const Setting& setting, Choice<Row>& target, const Rows& rows) const {
        line.choice(group, rows, target, setting);
    }
    template <class Rows>
    void operator()(const Setting& setting, fields::ReferenceChoice& target, const Rows& rows) const {
        line.value(group, setting, target.name(), [&target](const std::string& given) { target = given; },
                   {.help = ", or a picture file of it", .values = values_of(line.fitting(rows))});
    }
};

void add_brick_options(CommandLine& line, app::RenderJob& job) {
    app::BrickOptions& options = job.bricks;
    line.value(Group::bricks, setting::brick, "", [&options](const std::string& given) {
        const app::Time length = parse_time(given);
        if (length.value <= 0) throw Error(ErrorCode::option_value_out_of_range, "length must be greater than 0");
        options.length = length;
    });
    app::each_brick_setting(job, AddOption{line, Group::bricks});
    line.choice(Group::bricks, app::time_scales, app::time_scales.front().name, setting::time,
                [&options](const app::TimeScaleRow& row) { options.time = row.scale; });
}

}  // namespace

void add_input_options(CommandLine& line, app::InputOptions& options, const std::string& name,
                       const std::string& help) {
    line.arguments(options.names, name, help);
    line.value(Group::input, setting::field_size, "", [&options](const std::string& given) {
        options.field_size = given == "source" ? Size{-1, -1} : parse_size(given);
    });
    line.number(Group::input, options.rate, setting::rate);
}

void add_name_options(CommandLine& line, app::InputOptions& options) {
    line.list(Group::input, options.name_patterns, setting::names,
              {.help = fmt::format("{}", fmt::join(video::known_recorders(), ", "))});
}

void add_join_option(CommandLine& line, app::InputOptions& options) {
    line.flag(Group::input, options.join, setting::join);
}

void add_span_options(CommandLine& line, video::FrameSpan& span) {
    line.value(Group::input, setting::start, std::string(setting::start.default_text),
               [&span](const std::string& given) {
                   const auto place = parse_place(given);
                   const auto* const asked = std::get_if<video::RequestedTime>(&place);
                   span.asked.start = asked ? std::optional(*asked) : std::nullopt;
                   set_start(span, asked ? app::Time{0, app::Time::Unit::seconds} : std::get<app::Time>(place));
               });
    line.value(Group::input, setting::end, "", [&span](const std::string& given) {
        const auto place = parse_place(given);
        span.end.reset();
        span.stop.reset();
        span.asked.end.reset();
        if (const auto* const asked = std::get_if<video::RequestedTime>(&place)) {
            span.asked.end = *asked;
        } else {
            set_end(span, std::get<app::Time>(place));
        }
    });
    line.value(Group::input, setting::between, "",
               [&span](const std::string& given) { span.asked.between = parse_day_part(given); });
}

void add_field_options(CommandLine& line, fields::FieldOptions& options) {
    fields::each_field_setting(options, AddOption{line, Group::fields});
}

void add_seed_options(CommandLine& line, fields::SeedOptions& options) {
    fields::each_seed_setting(options, AddOption{line, Group::fields});
}

void add_preset_option(CommandLine& line, Group group) {
    line.choice(group, presets(), "", setting::preset, [](const Preset&) {});  // applied before parsing
}

void add_backend_options(CommandLine& line, app::BackendOptions& backend) {
    line.choice(Group::run, gl::backends(), backend.row, setting::backend);
    line.number(Group::run, backend.device, setting::device);
}

void add_thread_options(CommandLine& line, int& threads) {
    line.number(Group::run, threads, setting::threads);
}

void add_picture_options(CommandLine& line, app::RenderJob& job) {
    add_span_options(line, job.fields.span);
    line.number(Group::input, job.bricks.step, setting::step);
    add_field_options(line, job.fields);
    line.text(Group::fields, job.seeds, setting::seeds);
    line.value(Group::fields, setting::seed_flags, std::string(setting::seed_flags.default_text),
               [&job](const std::string& given) {
                   job.seed_flags = fields::SeedFlags::parse(given);
                   if (job.seed_flags) return;
                   throw Error(ErrorCode::option_value,
                               fmt::format("'{}': 1 to {} digits 0 or 1 were expected, one per brick", given,
                                           fields::SeedFlags::most));
               });
    add_brick_options(line, job);
    add_view_options(line, job);
    add_look_options(line, job);
    add_preset_option(line, Group::look);
    add_thread_options(line, job.fields.threads);
    add_backend_options(line, job.backend);
    line.flag(Group::run, job.backend.debug, setting::gl_debug);
}

image::Metadata shown(const std::vector<OptionValue>& values) {
    image::Metadata settings;
    for (const OptionValue& value : values) settings.emplace_back(value.name, value.shown());
    return settings;
}

void finish(const CommandLine& line, app::RenderJob& job, bool series) {
    if (line.has(setting::brick) && line.has(setting::window) && !series) {
        throw Error(ErrorCode::options_conflict,
                    "--brick excludes --window where one picture shows the whole clip; leave one of them out, or write "
                    "a series: -o out.{brick:4}.png");
    }
    job.settings = shown(line.values(picture_groups));
    // Recorded settings must be valid as options again: with --brick, don't record --window.
    if (line.has(setting::brick) && !series)
        std::erase_if(job.settings, [](const auto& one) { return one.first == setting::window.name; });
    job.given = shown(line.given(std::array{Group::input, Group::fields}));
    // These settings concern the render, not the fields of an extraction.
    std::erase_if(job.given, [](const auto& given) {
        return given.first == setting::step.name || given.first == setting::seeds.name ||
               given.first == setting::names.name || given.first == setting::join.name ||
               given.first == setting::seed_flags.name;
    });
}

namespace {

void set_direction(space::View& view, const std::string& text) {
    std::tie(view.azimuth, view.elevation) = parse_pair(text, ',', {-360, 360}, {-90, 90});
}

}  // namespace

void add_view_options(CommandLine& line, app::RenderJob& job) {
    constexpr Group view = Group::view;
    gl::RenderOptions& picture = job.picture;
    app::each_view_setting(job, AddOption{line, view});
    line.value(view, setting::radius, fmt::format("{}:{}", job.shape.r_min, job.shape.r_max),
               [&shape = job.shape](const std::string& given) {
                   std::tie(shape.r_min, shape.r_max) =
                       parse_pair(given, ':', setting::radius.range, setting::radius.range);
                   app::validate(shape);
               });
    line.value(view, setting::height, "", [&shape = job.shape](const std::string& given) {
        shape.height = parse_number(given, setting::height.range);
    });
    line.value(view, setting::size, fmt::format("{}x{}", picture.size.width, picture.size.height),
               [&picture](const std::string& given) { picture.size = parse_size(given); });
    line.value(view, setting::camera, fmt::format("{},{}", picture.view.azimuth, picture.view.elevation),
               [&picture](const std::string& given) { set_direction(picture.view, given); });
    line.value(view, setting::slice_view, "", [&look = job.look](const std::string& given) {
        look.slice_view.emplace();
        set_direction(*look.slice_view, given);
    });
    line.value(view, setting::slices, std::string(setting::slices.default_text), [&picture](const std::string& given) {
        const auto [low, high] = setting::slices.range;
        picture.slices = given == "auto" ? 0
                                         : static_cast<int>(parse_integer(given, static_cast<std::int64_t>(low),
                                                                          static_cast<std::int64_t>(high)));
    });
}

namespace {

app::Parts parse_parts(const std::string& text) {
    app::Parts shown;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');)
        shown.add(choose(setting::show.name, word, app::parts()).part);
    return shown;
}

std::string text_of(const app::Parts& shown) {
    std::string text;
    for (const app::PartRow& row : app::parts()) {
        if (shown.has(row.part)) text += fmt::format("{}{}", text.empty() ? "" : ",", row.name);
    }
    return text;
}

/// The transfer functions of themes, and the filters that have their own.
std::string default_transfers() {
    std::string text =
        defaults_of(scene::themes(), [](const scene::Theme& theme) { return std::string(theme.transfer); });
    for (const fields::FilterRow& filter : fields::filters()) {
        if (!filter.transfer.empty()) text += fmt::format("; {}: {}", filter.name, filter.transfer);
    }
    return text;
}

/// Premultiplied with its opacity.
glm::vec4 parse_colour(const std::string& text) {
    if (text == "none") return glm::vec4(0);
    unsigned value = 0;
    const char* const end = text.data() + text.size();
    const bool hex = text.size() == 7 && text[0] == '#' && std::from_chars(text.data() + 1, end, value, 16).ptr == end;
    if (!hex) throw Error(ErrorCode::option_value, fmt::format("'{}': a colour is #rrggbb, or none", text));
    return {static_cast<float>(value >> 16 & 255U) / 255, static_cast<float>(value >> 8 & 255U) / 255,
            static_cast<float>(value & 255U) / 255, 1};
}

}  // namespace

app::StartTime parse_start_time(const std::string& text) {
    using From = app::StartTime::From;
    constexpr std::pair<std::string_view, From> words[] = {{"recorded", From::recorded},
                                                           {"container", From::container},
                                                           {"modified", From::modified},
                                                           {"none", From::none}};
    for (const auto& [word, from] : words) {
        if (text == word) return {from};
    }
    if (const auto seconds = parse_date_time(text)) return {From::given, *seconds};
    throw Error(ErrorCode::option_value,
                fmt::format("'{}': a date and time is written 2026-11-21 08:00:00; or it is "
                            "'recorded', 'container', 'modified' or 'none'. To begin later in the "
                            "clip, take --start",
                            text));
}

void add_start_time_option(CommandLine& line, app::StartTime& start) {
    line.value(Group::look, setting::start_time, "",
               [&start](const std::string& given) { start = parse_start_time(given); },
               {.defaults = std::string(setting::start_time.default_text)});
}

void add_look_options(CommandLine& line, app::RenderJob& job) {
    constexpr Group group = Group::look;
    app::LookOptions& look = job.look;
    line.value(group, setting::show, text_of(look.show),
               [&look](const std::string& given) { look.show = parse_parts(given); },
               {.values = values_of(app::parts())});
    line.choice(group, scene::themes(), look.theme.name, setting::theme,
                [&look](const scene::Theme& row) { look.theme = row; });
    line.value(group, setting::background, "",
               [&look](const std::string& given) { look.background = parse_colour(given); });
    add_start_time_option(line, look.start_time);
    line.value(
        group, setting::transfer, std::string(setting::transfer.default_text),
        [&look](const std::string& given) { look.transfer = scene::find_transfer(given); },
        {.help = list_of(scene::transfer_functions()) + ", or a file of points", .defaults = default_transfers()});
    line.choice(group, gl::volume_shadings(), gl::volume_shadings().front().name, setting::shading,
                [&job](const gl::VolumeShadingRow& row) { job.picture.shading = row.shading; });
    app::each_look_setting(job, AddOption{line, group});
}

}  // namespace vvr::options
