#include "cli/app/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "cli/app/settings.h"
#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/memory.h"
#include "core/fields/flow.h"
#include "core/fields/region.h"
#include "core/image/picture_file.h"
#include "core/image/video_encoder.h"
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

/// Removes parts that need objects if the filter marks none. Arrows of the flow replace arrows along trails.
void drop_impossible_parts(const RenderJob& job, bool marks_objects, Parts& show) {
    // Show seeds that the user has listed.
    if (!job.seeds.empty() && !show.any(&PartRow::needs_seeds)) show.add(Part::arrows);
    if (marks_objects) return;
    if (show.has(Part::directions)) show.add(Part::arrows);
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

Products products_of(const RenderJob& job, bool marks_objects, Purpose purpose) {
    if (purpose == Purpose::search) return {.pictures = 0, .events = true};
    const OutputOptions& output = job.output;
    const bool page = !page_of(output).empty();
    Products products;
    products.series = purpose == Purpose::stream || is_series(output);
    products.pixel_data = page || output.returns_pixel_data ||
                          (!output.path.empty() && !is_standard_output(output.path) &&
                           !image::is_animation(output.path) && image::holds_pixel_data(output.path));
    products.only_page = page && (output.path.empty() || is_page(output.path)) && purpose != Purpose::caller;
    if (purpose == Purpose::stream) {
        products.portraits = page;
        return products;
    }
    products.pictures = std::max(pictures_of(output), purpose == Purpose::caller ? 1 : 0);
    // Events need a filter that marks objects.
    products.events = (page || output.lists_events()) && marks_objects;
    products.portraits = page && products.events;
    return products;
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
    const std::int64_t picture_bytes = plan.products.pixel_data ? 56 : 20;  // per pixel, as floats and as bytes
    // Per voxel, in a layer and in a texture, when no voxel is empty. A street scene needs a twentieth and a half of
    // that, respectively.
    const gl::VolumeColour colour = plan.colour->drawn;
    const std::int64_t voxel_bytes = colour == gl::VolumeColour::own || colour == gl::VolumeColour::object ? 4 : 1;
    const auto pieces = static_cast<int>((extent.layers + volume::sub_brick_layers - 1) / volume::sub_brick_layers);
    const std::int64_t in_textures = extent.layers * textures_of(plan.products, pieces) / std::max(1, pieces);
    // With unequal lengths, there are up to 1.5 times as many layers during reading, but no more than frames.
    std::int64_t held = plan.nonuniform ? extent.layers * 3 / 2 : extent.layers;
    if (plan.nonuniform && extent.frames > 0) held = std::min(held, extent.frames);
    // The flow of about a hundred frames, as half floats.
    const std::int64_t flow_bytes = plan.job.look.show.any(&PartRow::needs_flow) ? 100 * 4 : 0;
    // Per field pixel: the time of its last change, and its object.
    const std::int64_t event_bytes = plan.finds_objects ? 40 : 0;
    const std::int64_t field = area(plan.clip.field_size);
    return program + (event_bytes + flow_bytes + voxel_bytes * (held + in_textures)) * field +
           frames_in_flight * (field_bytes * field + source_bytes * area(plan.clip.info.size)) +
           picture_bytes * area(plan.picture.size);
}

Extent extent_of(const Plan& plan) {
    const BrickOptions& bricks = plan.job.bricks;
    Extent extent;
    extent.frames = plan.clip.expected_frames;
    if (plan.products.series) {
        extent.step = plan.window.step;
        extent.layers = plan.window.layers();
        extent.bricks = plan.window.bricks;
    } else if (plan.nonuniform && extent.frames > 0) {
        extent.layers = std::min(extent.frames, bricks.max_layers);
        extent.step = std::max<std::int64_t>(
            1, std::llround(static_cast<double>(extent.frames) / static_cast<double>(extent.layers)));
        extent.bricks = bricks_of(bricks, extent, plan.clip.info.rate);
    } else {
        extent.step = planned_step(bricks, extent.frames);
        while (extent.frames > bricks.max_layers * extent.step) extent.step *= 2;
        extent.layers = extent.frames > 0 ? (extent.frames + extent.step - 1) / extent.step : bricks.max_layers;
        extent.bricks = bricks_of(bricks, extent, plan.clip.info.rate);
    }
    extent.bytes = bytes_of(plan, extent);
    return extent;
}

}  // namespace

std::int64_t SlidingWindow::pieces_of_brick() const {
    return std::ssize(
        volume::cut_into_sub_bricks(volume::cut_at(std::array{volume::Brick{0, brick_layers}}, key_layers)));
}

std::int64_t planned_step(const BrickOptions& bricks, std::int64_t frames) {
    if (bricks.step > 0) return bricks.step;
    return std::max<std::int64_t>(1, (frames + bricks.max_layers - 1) / bricks.max_layers);
}

int textures_of(const Products& products, int pieces) {
    const bool drawn_again = products.series || products.pictures > 1;
    return std::max(1, drawn_again ? pieces : std::min(2, pieces));
}

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

/// The areas that the settings leave out of the scene, and their share of it.
void set_areas(Plan& plan) {
    const bool is_extracted = !plan.clip.extracted.empty();  // then files of areas are not at hand
    fields::FieldOptions areas;
    areas.roi = plan.job.fields.roi;
    areas.mask = plan.job.fields.mask;
    for (const auto& [name, area] : {std::pair(setting::roi.name, areas.roi), {setting::mask.name, areas.mask}}) {
        const std::string value = image::value_of(plan.job.settings, name);
        if (is_extracted ? value.empty() : area.empty()) continue;
        plan.areas.push_back({std::string(name), value, {}});
        if (!is_extracted)
            plan.areas.back().sha256 =
                fields::is_polygon_list(area) ? hex_sha256(area) : hex_sha256(read_file(area, most_bytes::data));
    }
    if (plan.areas.empty()) return;
    plan.masked.reset();
    if (is_extracted) return;
    const Plane<std::uint8_t> region = fields::make_region(areas, plan.clip.field_size, plan.clip.info.size);
    plan.masked =
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
    const fields::FilterRow* const second = colour.filter;
    const std::string_view second_own = second == nullptr ? "" : second->transfer;
    const scene::TransferFunction transfer = transfer_or(job.look, job.look.theme.transfer);
    Plan plan{.filter = &filter,
              .colour = &colour,
              .second = second,
              .reference = job.fields.reference.row(),
              .transfer = transfer,
              .drawn_transfer = transfer.scaled(job.look.opacity),
              .second_transfer = transfer_or(job.look, second_own.empty() ? "viridis" : second_own)};
    plan.detector = std::move(detector);
    plan.products = products_of(job, marks_objects, purpose);
    plan.nonuniform = !plan.products.series && wants_room_for_motion(job.bricks, clip);
    plan.finds_objects = plan.products.events || job.output.reports_events || plan.colours_objects() ||
                         job.look.show.any(&PartRow::needs_events) || (plan.nonuniform && marks_objects);
    plan.layout = space::make_layout(job.layout, space::shape_for(clip.field_size, job.shape));
    plan.glyphs.time_velocity = job.look.traces.time_velocity;
    plan.glyphs.frames *= job.look.glyph_scale;
    plan.glyphs.cap *= job.look.glyph_scale;
    plan.picture = job.picture;
    plan.picture.colour = plan.colour->drawn;
    // A page shows its own ground through a light picture, and makes its colours lighter where the ground is dark.
    const bool clear = plan.products.only_page && job.look.theme.background == glm::vec3(1);
    const glm::vec4 ground = clear ? glm::vec4(0) : glm::vec4(job.look.theme.background, 1);
    plan.picture.background = job.look.background.value_or(ground);
    plan.picture.glyphs = glyph_style_of(job, plan.colours_objects());
    plan.title = title_of(job.look.title, clip.info);
    plan.clock = clock_of(job.look.start_time, clip.info);
    if (plan.clock) plan.clock->lasts = clip.span.end.value_or(clip.info.duration) - clip.span.start;
    plan.job = std::move(job);
    plan.clip = std::move(clip);
    if (plan.products.series) plan.window = sliding_window(plan.job.bricks, plan.job.look.keyframes, plan.clip);
    plan.extent = extent_of(plan);
    set_areas(plan);
    return plan;
}

Framing Plan::framing() const {
    Framing framing;
    const Parts& show = job.look.show;
    framing.sheet = annotation::arrange_sheet(job.picture.size,
                                              {.title = shows(Part::title),
                                               .ruler = shows(Part::ruler),
                                               .legend = shows(Part::legend),
                                               .explanation = shows(Part::explanation),
                                               .portraits = shows(Part::portraits),
                                               .ends = shows(Part::ends),
                                               .strip = shows(Part::strip),
                                               .large_captions = products.only_page},
                                              static_cast<double>(clip.field_size.width) / clip.field_size.height);
    const PixelBox& part = framing.sheet.volume;
    const std::vector<glm::dvec3> outline = scene::outline_points(*layout);
    std::vector<glm::dvec3> points =
        show.any(&PartRow::around_volume) ? scene::corners(scene::layout_bounds(*layout)) : outline;
    space::View view = job.picture.view;
    if (framing.sheet.text > 0) view.margin = 0.01;  // the sheet already leaves a margin
    space::Camera camera = space::fit_camera(view, points, part.size());
    framing.edge = annotation::outer_edge(*layout, camera, part.size());
    if (shows(Part::ruler)) {
        const std::vector<glm::dvec3> reach = annotation::ruler_reach(*layout, framing.edge);
        points.insert(points.end(), reach.begin(), reach.end());
        camera = space::fit_camera(view, points, part.size());
    }
    framing.camera = camera.within(part, job.picture.size);
    double side = 0;
    for (const glm::dvec3& p : outline) side = std::max(side, framing.camera.pixel_size(p, job.picture.size));
    framing.half_pixel = side * std::numbers::sqrt2 / 2;
    return framing;
}

}  // namespace vvr::app
