#include "cli/plan/make_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cli/plan/input.h"
#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/fields/flow.h"
#include "core/fields/region.h"
#include "core/image/picture_file.h"
#include "core/image/video_encoder.h"
#include "core/media/container.h"
#include "core/media/input.h"
#include "core/scene/scene.h"
#include "core/volume/brick.h"

namespace vvr::app {

namespace {

// ---- Settings that depend on other settings

void take_extracted(const image::Metadata& extracted, RenderJob& job) {
    for (const auto& [name, value] : extracted) {
        if (name == setting::filter.name) job.fields.filter = value;
        image::put(job.settings, name, value);
    }
}

/// Removes parts that need objects if the filter marks none. Arrows of the flow replace arrows along trails, and all
/// that is shown of objects by default.
void drop_impossible_parts(const RenderJob& job, bool marks_objects, Parts& show) {
    // Show seeds that the user has listed.
    if (!job.seeds.empty() && !show.any(&PartRow::needs_seeds)) show.add(Part::arrows);
    if (marks_objects) return;
    if (show.has(Part::directions) || show == Parts::by_default()) show.add(Part::arrows);
    for (const PartRow& row : parts()) {
        if (row.needs_events) show.remove(row.part);
    }
}

/// The colour of the volume. If none is chosen, objects have their own colours, provided that a part shows them, the
/// filter marks objects, and no transfer function is chosen.
const ColourRow& choose_colour(const RenderJob& job, bool marks_objects) {
    const LookOptions& look = job.look;
    const ColourRow& asked = *look.colour;
    if (asked.drawn == gl::VolumeColour::object && !marks_objects) {
        throw Error(ErrorCode::options_conflict,
                    fmt::format("color object: the filter '{}' marks no objects; use another filter, or color transfer",
                                job.fields.filter->name),
                    {setting::colour.name, setting::filter.name});
    }
    const bool second_flow = asked.filter != nullptr && asked.filter->traits.flow;
    if ((asked.needs_flow || second_flow) && !fields::has_flow(job.fields.flow)) {
        throw Error(ErrorCode::options_conflict,
                    fmt::format("color {} needs flow, but flow {} computes none; use another flow or colour",
                                asked.name, job.fields.flow.method.name()),
                    {setting::colour.name, setting::flow.name});
    }
    if (&asked != &colour_rows().front()) return asked;
    const bool describes_objects = look.show.has(Part::volume) && look.show.any(&PartRow::needs_events);
    return *Choice<ColourRow>(describes_objects && marks_objects && !look.transfer ? "object" : "transfer");
}

scene::TransferFunction transfer_or(const LookOptions& look, std::string_view otherwise) {
    return look.transfer ? look.transfer->function : scene::find_transfer(std::string(otherwise));
}

/// Completes the record with what depends on the footage. Settings without a value are left out.
void complete_record(RenderJob& job, const ColourRow& colour, bool chose_transfer) {
    const LookOptions& look = job.look;
    image::put(job.settings, setting::colour.name, colour.name);
    // A second filter has its own transfer function: no single name describes both.
    if (!chose_transfer && colour.filter == nullptr) {
        const std::string theme(look.theme.transfer);
        image::put(job.settings, setting::transfer.name, look.transfer ? look.transfer->name : theme);
    }
    std::erase_if(job.settings, [](const auto& one) { return one.second.empty(); });
}

gl::GlyphStyle glyph_style_of(const RenderJob& job, bool between_objects) {
    gl::GlyphStyle style = job.picture.glyphs;
    style.slow_colour = job.look.theme.slow;
    style.fast_colour = job.look.theme.fast;
    style.thickness *= static_cast<float>(job.look.glyph_scale);
    // Between coloured objects, arrows show the direction only; their colour has no meaning.
    if (between_objects) {
        style.slow_colour = style.fast_colour = job.look.theme.ink;
        style.thickness *= 1.3F;
    }
    return style;
}

/// Sets what the run produces.
void set_products(const RenderJob& job, Purpose purpose, Plan& plan) {
    const bool marks_objects = plan.field.filter->traits.shows_object;
    plan.field.events = job.output.events;
    if (purpose == Purpose::search) {
        plan.output.pictures = 0;
        plan.field.lists_events = true;
        return;
    }
    const OutputOptions& output = job.output;
    const bool page = !page_of(output).empty();
    plan.volume.series = purpose == Purpose::stream || is_series(output);
    plan.look.pixel_data = page || output.returns_pixel_data ||
                           (!output.path.empty() && !is_standard_output(output.path) &&
                            !image::is_animation(output.path) && image::holds_pixel_data(output.path));
    plan.look.only_page = page && (output.path.empty() || is_page(output.path)) && purpose != Purpose::caller;
    plan.field.keeps_moments = page || !output.still.empty() || purpose == Purpose::stream;
    plan.field.keeps_boxes = !output.tracks.empty();
    if (purpose == Purpose::stream) {
        plan.field.keeps_portraits = page;
        return;
    }
    plan.output.pictures = std::max(pictures_of(output), purpose == Purpose::caller ? 1 : 0);
    // Events need a filter that marks objects.
    plan.field.lists_events = (page || output.lists_events()) && marks_objects;
    plan.field.keeps_portraits = page && plan.field.lists_events;
}

/// Whether layers get room according to motion: if chosen, or by default if the header's length is above two minutes
/// and no step is given.
bool wants_room_for_motion(const BrickOptions& bricks, const ClipFacts& clip) {
    constexpr double short_recording = 120;  // seconds
    if (bricks.time != TimeScale::automatic) return bricks.time == TimeScale::busy;
    if (bricks.step > 0) return false;  // a given number of frames per layer means equal layers
    return clip.info.rate > 0 && static_cast<double>(clip.expected_frames) > short_recording * clip.info.rate;
}

// ---- Layers, bricks and memory

constexpr double default_seconds = 10;
constexpr double default_frames = 100;  // if the frame rate is unknown

double frames_of_brick(const BrickOptions& bricks, const ClipFacts& clip) {
    const media::VideoInfo& info = clip.info;
    if (bricks.length && bricks.length->unit == Time::Unit::frames) return bricks.length->value;
    if (bricks.length) {
        if (info.rate > 0) return bricks.length->value * info.rate;
        throw Error(ErrorCode::option_value,
                    fmt::format("brick of {} s: '{}' has no frame rate; give the length of a brick in frames, for "
                                "example {:.0f}f",
                                bricks.length->value, info.name, default_frames),
                    {setting::brick.name});
    }
    const double brick = info.rate > 0 ? default_seconds * info.rate : default_frames;
    const auto expected = static_cast<double>(clip.expected_frames);
    return expected > 0 ? std::min(brick, std::ceil(expected / bricks.window)) : brick;
}

/// The window of a series. A brick has the given length; by default 10 s, or less if the clip is shorter than k such
/// bricks.
SlidingWindow sliding_window(const BrickOptions& bricks, int keyframes, const ClipFacts& clip) {
    SlidingWindow window;
    window.bricks = bricks.window;
    const double brick = std::max(1.0, std::round(frames_of_brick(bricks, clip)));
    const auto frames = static_cast<std::int64_t>(brick) * bricks.window;
    window.step = planned_step(bricks, frames);
    while (frames > bricks.max_layers * window.step) window.step *= 2;
    const double layers = std::round(brick / static_cast<double>(window.step));
    window.brick_layers = std::max<std::int64_t>(1, static_cast<std::int64_t>(layers));
    // Key frames divide a brick evenly.
    for (std::int64_t j = 0; j < keyframes; ++j) window.key_layers.push_back(j * window.brick_layers / keyframes);
    return window;
}

std::int64_t area(Size size) {
    return std::int64_t{size.width} * size.height;
}

std::int64_t bricks_of(const BrickOptions& bricks, const Extent& extent, double rate) {
    if (!bricks.length) return std::min<std::int64_t>(bricks.window, extent.layers);
    const double length = bricks.length->value * (bricks.length->unit == Time::Unit::seconds ? rate : 1);
    if (length <= 0) return std::min<std::int64_t>(bricks.window, extent.layers);
    return static_cast<std::int64_t>(std::ceil(static_cast<double>(extent.layers * extent.step) / length));
}

std::int64_t bytes_of(const Plan& plan, const Extent& extent) {
    constexpr std::int64_t program = 230'000'000;  // code, libraries, OpenGL
    constexpr std::int64_t frames_in_flight = 16;
    constexpr std::int64_t field_bytes = 30;  // per pixel of a frame being processed: colour, float planes, flow
    constexpr std::int64_t source_bytes = 2;  // per pixel of a decoded picture
    const std::int64_t picture_bytes = plan.look.pixel_data ? 56 : 20;  // per pixel, as floats and as bytes
    // Per voxel, in a layer and in a texture, when no voxel is empty. A street scene needs a twentieth and a half of
    // that, respectively.
    const gl::VolumeColour colour = plan.volume.colour->drawn;
    const std::int64_t voxel_bytes = colour == gl::VolumeColour::own || colour == gl::VolumeColour::object ? 4 : 1;
    const auto pieces = static_cast<int>((extent.layers + volume::sub_brick_layers - 1) / volume::sub_brick_layers);
    const std::int64_t in_textures = extent.layers * plan.volume.textures(pieces) / std::max(1, pieces);
    // With unequal lengths, there are up to 1.5 times as many layers during reading, but no more than frames.
    std::int64_t held = plan.volume.nonuniform ? extent.layers * 3 / 2 : extent.layers;
    if (plan.volume.nonuniform && extent.frames > 0) held = std::min(held, extent.frames);
    // The flow of about a hundred frames, as half floats.
    const std::int64_t flow_bytes = plan.field.flow ? 100 * 4 : 0;
    // Per field pixel: the time of its last change, and its object.
    const std::int64_t event_bytes = plan.field.finds_objects ? 40 : 0;
    const std::int64_t field = area(plan.read.clip.field_size);
    return program + (event_bytes + flow_bytes + voxel_bytes * (held + in_textures)) * field +
           frames_in_flight * (field_bytes * field + source_bytes * area(plan.read.clip.info.size)) +
           picture_bytes * area(plan.look.picture.size);
}

Extent extent_of(const Plan& plan) {
    const BrickOptions& bricks = plan.volume.bricks;
    Extent extent;
    extent.frames = plan.read.clip.expected_frames;
    if (plan.volume.series) {
        extent.step = plan.volume.window.step;
        extent.layers = plan.volume.window.layers();
        extent.bricks = plan.volume.window.bricks;
    } else if (plan.volume.nonuniform && extent.frames > 0) {
        extent.layers = std::min(extent.frames, bricks.max_layers);
        extent.step = std::max<std::int64_t>(
            1, std::llround(static_cast<double>(extent.frames) / static_cast<double>(extent.layers)));
        extent.bricks = bricks_of(bricks, extent, plan.read.clip.info.rate);
    } else {
        extent.step = planned_step(bricks, extent.frames);
        while (extent.frames > bricks.max_layers * extent.step) extent.step *= 2;
        extent.layers = extent.frames > 0 ? (extent.frames + extent.step - 1) / extent.step : bricks.max_layers;
        extent.bricks = bricks_of(bricks, extent, plan.read.clip.info.rate);
    }
    extent.bytes = bytes_of(plan, extent);
    return extent;
}

}  // namespace

void check_memory(const Extent& extent) {
    const std::int64_t there = machine_memory();
    if (there <= 0 || extent.bytes <= there) return;
    throw Error(ErrorCode::memory_too_small,
                fmt::format("this needs about {:.1f} GB of memory, but the machine has {:.1f} GB; choose a smaller "
                            "picture, smaller fields or fewer layers",
                            static_cast<double>(extent.bytes) / 1e9, static_cast<double>(there) / 1e9),
                {setting::size.name, setting::field_size.name, setting::layers.name});
}

namespace {

/// The file extension for pieces cut from the clip; empty = unknown.
std::string cut_ending(const std::string& file, double rate) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none)) return {};
    try {
        return std::string(media::extension_for(media::open_input(file), rate));
    } catch (const Error&) {
        return {};
    }
}

PagePlan page_plan(const RenderJob& job, const media::VideoInfo& info, Purpose purpose) {
    const OutputOptions& output = job.output;
    PagePlan page{.path = output.page_place.empty() ? page_of(output) : output.page_place,
                  .index = output.page_index,
                  .pieces = output.pieces.place,
                  .camera = output.page_camera,
                  .heading = output.page_heading,
                  .is_titled = !job.look.title.empty()};
    if (page_of(output).empty() || job.input.names.empty()) return page;
    page.file =
        job.input.names.size() > 1 ? counted(std::ssize(job.input.names), "file") : shown_name(job.input.names.front());
    page.turns = !output.flat_page;
    const std::string& input = job.input.names.front();
    if (purpose == Purpose::stream) {
        if (input == "-") page.file.clear();  // "stdin" tells nobody anything
        return page;
    }
    std::error_code none;
    page.plays_file = info.segments.empty() && std::filesystem::is_regular_file(input, none);
    page.file_ending = cut_ending(info.segments.empty() ? input : info.segments.front().path, job.input.rate);
    return page;
}

/// The areas that the settings leave out of the scene, and their share of it.
void set_areas(const fields::FieldOptions& options, Plan& plan) {
    const bool is_extracted = !plan.read.clip.extracted.empty();  // then files of areas are not at hand
    fields::FieldOptions areas;
    areas.roi = options.roi;
    areas.mask = options.mask;
    for (const auto& [name, area] : {std::pair(setting::roi.name, areas.roi), {setting::mask.name, areas.mask}}) {
        const std::string value = image::value_of(plan.output.settings, name);
        if (is_extracted ? value.empty() : area.empty()) continue;
        plan.field.areas.push_back({std::string(name), value, {}});
        if (!is_extracted)
            plan.field.areas.back().sha256 =
                fields::is_polygon_list(area) ? hex_sha256(area) : hex_sha256(read_file(area, most_bytes::data));
    }
    if (plan.field.areas.empty()) return;
    plan.field.masked.reset();
    if (is_extracted) return;
    const Plane<std::uint8_t> region = fields::make_region(areas, plan.read.clip.field_size, plan.read.clip.info.size);
    plan.field.masked =
        static_cast<double>(std::ranges::count(region.pixels(), 0)) / static_cast<double>(region.pixels().size());
}

}  // namespace

Plan make_plan(RenderJob job, ClipFacts clip, Purpose purpose, std::shared_ptr<detector::Detector> detector) {
    take_extracted(clip.extracted, job);
    if (clip.extracted.empty()) job.fields.span = clip.span;
    const fields::FilterRow& filter = *job.fields.filter;
    const bool marks_objects = filter.traits.shows_object;
    drop_impossible_parts(job, marks_objects, job.look.show);
    const bool chose_transfer = job.look.transfer.has_value();
    if (!chose_transfer && !filter.transfer.empty()) {
        const std::string name(filter.transfer);
        job.look.transfer = NamedTransfer{name, scene::find_transfer(name)};
    }
    const ColourRow& colour = choose_colour(job, marks_objects);
    complete_record(job, colour, chose_transfer);
    const std::string_view second_own = colour.filter == nullptr ? "" : colour.filter->transfer;
    const scene::TransferFunction transfer = transfer_or(job.look, job.look.theme.transfer);

    Plan plan;
    plan.field.filter = &filter;
    plan.field.reference = job.fields.reference.row();
    plan.field.detector = std::move(detector);
    plan.field.flow = job.look.show.any(&PartRow::needs_flow);
    plan.field.seeds = job.look.show.any(&PartRow::needs_seeds);
    plan.field.has_roi = !job.fields.roi.empty();
    plan.field.has_region = fields::has_region(job.fields);
    set_products(job, purpose, plan);

    plan.volume.bricks = job.bricks;
    plan.volume.nonuniform = !plan.volume.series && wants_room_for_motion(job.bricks, clip);
    plan.volume.drawn_again = plan.volume.series || plan.output.pictures > 1;
    plan.volume.keyframes = job.look.keyframes;
    plan.volume.seed_flags = job.seed_flags;
    plan.volume.colour = &colour;
    plan.volume.second_transfer = transfer_or(job.look, second_own.empty() ? "viridis" : second_own);
    plan.volume.theme = job.look.theme;
    plan.field.finds_objects = plan.field.lists_events || job.output.reports_events || plan.volume.colours_objects() ||
                               job.look.show.any(&PartRow::needs_events) || (plan.volume.nonuniform && marks_objects);

    plan.look.show = job.look.show;
    plan.look.theme = job.look.theme;
    plan.look.transfer = transfer;
    plan.look.drawn_transfer = transfer.scaled(job.look.opacity);
    plan.look.shape = job.layout;
    plan.look.layout = space::make_layout(job.layout, space::shape_for(clip.field_size, job.shape));
    plan.look.field = clip.field_size;
    plan.look.glyphs.time_velocity = job.look.traces.time_velocity;
    plan.look.glyphs.frames *= job.look.glyph_scale;
    plan.look.glyphs.cap *= job.look.glyph_scale;
    plan.look.traces = job.look.traces;
    plan.look.picture = job.picture;
    plan.look.picture.colour = colour.drawn;
    // A page shows its own ground through a light picture, and makes its colours lighter where the ground is dark.
    const bool clear = plan.look.only_page && job.look.theme.background == glm::vec3(1);
    const glm::vec4 ground = clear ? glm::vec4(0) : glm::vec4(job.look.theme.background, 1);
    plan.look.picture.background = job.look.background.value_or(ground);
    plan.look.picture.glyphs = glyph_style_of(job, plan.volume.colours_objects());
    plan.volume.speed_range = plan.look.picture.glyphs.speed_range;
    plan.look.title = title_of(job.look.title, clip.info);
    plan.look.backend = job.backend;
    plan.field.keeps_frames = plan.look.shows(Part::frames) && job.look.keyframes > 0;
    plan.field.keeps_portraits = plan.field.keeps_portraits || plan.look.shows(Part::portraits);
    plan.look.stills = plan.look.shows(Part::ends) && plan.volume.colours_objects() && !plan.volume.series;
    // Without stills, the room for them would be empty.
    constexpr int without_stills = 800;
    if (!plan.look.stills && plan.look.picture.size == gl::RenderOptions().size)
        plan.look.picture.size.height = without_stills;
    plan.field.keeps_stills = plan.look.stills && !plan.look.framing().sheet.stills.empty();

    plan.read.span = job.fields.span;
    plan.read.threads = job.fields.threads;
    const bool names_camera = !page_of(job.output).empty() || job.output.lists_events();
    if (names_camera) plan.read.camera = camera_of(job, clip.info);
    plan.read.clock = clock_of(job.look.start_time, clip.info);
    if (plan.read.clock) plan.read.clock->lasts = clip.span.end.value_or(clip.info.duration) - clip.span.start;
    plan.read.wants_clock = job.look.start_time.from != StartTime::From::none;
    plan.page = page_plan(job, clip.info, purpose);
    plan.read.clip = std::move(clip);
    if (plan.volume.series) plan.volume.window = sliding_window(job.bricks, job.look.keyframes, plan.read.clip);
    plan.volume.extent = extent_of(plan);
    plan.read.input = std::move(job.input);
    plan.output.files = std::move(job.output);
    plan.output.settings = std::move(job.settings);
    set_areas(job.fields, plan);
    return plan;
}

}  // namespace vvr::app
