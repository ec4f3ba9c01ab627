#include "cli/app/job.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "cli/app/settings.h"
#include "core/base/error.h"
#include "core/base/file_io.h"
#include "core/base/file_name.h"
#include "core/fields/field_source.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/fields/reference.h"
#include "core/image/film.h"
#include "core/image/picture_file.h"
#include "core/image/text.h"
#include "core/scene/transfer_function.h"

namespace vvr::app {

image::NamePattern name_of(const OutputOptions& options) {
    return options.plain_name ? image::NamePattern::literal(options.path) : image::NamePattern(options.path);
}

bool is_series(const OutputOptions& options) {
    return options.slide || (!options.animate && name_of(options).has_field());
}

bool is_page(const std::filesystem::path& path) {
    const std::string ending = extension_of(path);
    return ending == ".html" || ending == ".htm";
}

const std::filesystem::path& page_of(const OutputOptions& options) {
    return is_page(options.path) ? options.path : options.page;
}

int pictures_of(const OutputOptions& options) {
    if (options.path.empty() && options.golden.path.empty()) return 0;
    if (options.slide) return *options.slide;
    return options.animate.value_or(image::is_animation(options.path) ? default_animation : 1);
}

void validate(const space::LayoutOptions& shape) {
    if (shape.height != 0) check(setting::height, shape.height);
    check(setting::radius, shape.r_min);
    check(setting::radius, shape.r_max);
    if (shape.r_min < shape.r_max) return;
    throw Error(
        ErrorKind::usage,
        fmt::format("radius: '{}:{}': the outer radius has to be larger than the inner one", shape.r_min, shape.r_max),
        {setting::radius.name});
}

void validate_series(const RenderJob& job) {
    if (job.bricks.time == TimeScale::busy) {
        throw Error(ErrorKind::usage,
                    "time busy is for one picture of a clip; the pictures of a series share one scale of time",
                    {setting::time.name});
    }
}

void validate(const RenderJob& job) {
    if (job.input.names.empty()) throw Error(ErrorKind::usage, "no input: name a video, a folder of pictures, or -");
    fields::validate(job.fields);
    const auto check_one = [](const Setting& setting, const auto& value, const auto&...) { check(setting, value); };
    each_brick_setting(job, check_one);
    each_view_setting(job, check_one);
    each_look_setting(job, check_one);
    check(setting::step, job.bricks.step);
    check(setting::slices, job.picture.slices);
    if (products_of(job).series) validate_series(job);
    validate(job.shape);
    if (!job.look.font.empty()) image::check_font(job.look.font);
}

Products products_of(const RenderJob& job) {
    const OutputOptions& output = job.output;
    const bool page = !page_of(output).empty();
    Products products;
    products.pictures = pictures_of(output);
    products.series = is_series(output);
    products.pixel_data = page || (!output.path.empty() && !is_standard_output(output.path) &&
                                   !image::is_animation(output.path) && image::holds_pixel_data(output.path));
    // Only what a filter that marks objects shows has events.
    products.events = (page || !output.report.empty()) && job.fields.filter->traits.shows_object;
    products.portraits = page && products.events;
    return products;
}

RenderJob with_extracted(RenderJob job, const image::Metadata& extracted) {
    for (const auto& [name, value] : extracted) {
        if (name == setting::filter.name) job.fields.filter = value;
        image::put(job.settings, name, value);
    }
    return job;
}

RenderJob with_possible_parts(RenderJob job) {
    Parts& show = job.look.show;
    // Who names seeds wants to see them.
    if (!job.seeds.empty() && !show.any(&PartRow::needs_seeds)) show.add(Part::arrows);
    if (job.fields.filter->traits.shows_object) return job;
    if (show.has(Part::directions)) show.add(Part::arrows);
    for (const PartRow& row : parts()) {
        if (row.needs_events) show.remove(row.part);
    }
    return job;
}

RenderJob with_fields_of_colour(RenderJob job) {
    job.fields.second = job.look.colour->filter;
    return job;
}

RenderJob with_transfer(RenderJob job) {
    const std::string_view own = job.fields.filter->transfer;
    if (!job.look.transfer && !own.empty()) job.look.transfer = scene::find_transfer(std::string(own));
    return job;
}

RenderJob with_colour(RenderJob job) {
    const bool marks_objects = job.fields.filter->traits.shows_object;
    const LookOptions& look = job.look;
    const ColourRow& asked = *look.colour;
    if (asked.drawn == gl::VolumeColour::object && !marks_objects) {
        throw Error(
            ErrorKind::usage,
            fmt::format("color object: the filter '{}' marks no objects; choose another filter, or color transfer",
                        job.fields.filter->name),
            {setting::colour.name, setting::filter.name});
    }
    const bool tells_objects = look.show.has(Part::volume) && look.show.any(&PartRow::needs_events);
    const bool objects = tells_objects && marks_objects && !look.transfer;
    const bool second_flow = asked.filter != nullptr && asked.filter->traits.flow;
    if ((asked.needs_flow || second_flow) && !fields::has_flow(job.fields.flow)) {
        throw Error(ErrorKind::usage,
                    fmt::format("color {}: it needs flow, and flow {} computes none; choose another flow or colour",
                                asked.name, job.fields.flow.method->name),
                    {setting::colour.name, setting::flow.name});
    }
    if (&asked == &colour_rows().front()) job.look.colour = objects ? "object" : "transfer";
    job.picture.colour = job.look.colour->drawn;
    image::put(job.settings, setting::colour.name, job.look.colour->name);
    return job;
}

bool finds_objects(const RenderJob& job, const Products& products) {
    return products.events || job.picture.colour == gl::VolumeColour::object ||
           job.look.show.any(&PartRow::needs_events);
}

bool wants_colour(const RenderJob& job) {
    // Objects are found by colour too, not only if the picture happens to show some.
    return job.fields.filter->traits.colour || fields::needs_reference(job.fields) ||
           job.look.show.any(&PartRow::needs_pictures) || job.look.colour->needs_pictures ||
           (job.fields.second != nullptr && job.fields.second->traits.colour);
}

scene::TransferFunction transfer_of(const LookOptions& look) {
    return look.transfer ? *look.transfer : scene::find_transfer(std::string(look.theme.transfer));
}

scene::TransferFunction drawn_transfer_of(const LookOptions& look) {
    return transfer_of(look).scaled(look.opacity);
}

glm::vec4 background_of(const LookOptions& look) {
    return look.background.value_or(glm::vec4(look.theme.background, 1));
}

scene::GlyphOptions glyph_options_of(const LookOptions& look) {
    scene::GlyphOptions options;
    options.time_velocity = look.traces.time_velocity;
    options.frames *= look.glyph_scale;
    options.cap = look.glyph_cap * look.glyph_scale;
    return options;
}

gl::GlyphStyle glyph_style_of(const RenderJob& job) {
    gl::GlyphStyle style = job.picture.glyphs;
    style.slow_colour = job.look.theme.slow;
    style.fast_colour = job.look.theme.fast;
    style.thickness *= static_cast<float>(job.look.glyph_scale);
    // Between objects in colours an arrow says which way, and its colour nothing.
    if (job.picture.colour == gl::VolumeColour::object) {
        style.slow_colour = style.fast_colour = job.look.theme.ink;
        style.thickness *= 1.3F;
    }
    return style;
}

WallClock clock_of(const StartTime& start, const video::VideoInfo& info) {
    using From = StartTime::From;
    if (start.from == From::given) return start.clock;
    if (start.from == From::none) return std::nullopt;
    const bool told = info.began && is_recording_time(info.began_source);
    struct Row {
        From from;
        std::optional<std::int64_t> begin;
        ClockSource source;
        std::string_view word;
        std::string_view missing;
    };
    const auto told_by = [&](ClockSource source) {
        return info.began_source == source ? info.began : std::optional<std::int64_t>();
    };
    const auto or_else = [](std::optional<std::int64_t> first, std::optional<std::int64_t> second) {
        return first ? first : second;
    };
    const Row rows[] = {
        {From::automatic, told ? info.began : std::nullopt, info.began_source, "", ""},
        {From::recorded, told ? info.began : std::nullopt, info.began_source, "recorded",
         "the name of '{}' does not say when it was recorded; give the date and time, or say with --names how it does"},
        {From::container, or_else(told_by(ClockSource::container), info.created), ClockSource::container, "container",
         "the container of '{}' does not say when it was written; give the date and time"},
        {From::modified, or_else(told_by(ClockSource::modified), info.modified), ClockSource::modified, "modified",
         "'{}' is no file that was written at some time; give the date and time"},
    };
    const Row& row = *std::ranges::find(rows, start.from, &Row::from);
    if (row.begin) return local_clock(*row.begin, info.duration, row.source);
    if (row.missing.empty()) return std::nullopt;
    throw Error(ErrorKind::usage,
                fmt::format("start-time {}: {}", row.word, fmt::format(fmt::runtime(row.missing), info.name)),
                {setting::start_time.name});
}

events::EventOptions event_options(const RenderJob& job) {
    events::EventOptions options;
    options.scene_is_learnt = job.fields.reference.row() != nullptr;
    return options;
}

}  // namespace vvr::app
