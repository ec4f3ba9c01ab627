#include "cli/app/draw.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "cli/app/colour.h"
#include "core/bricks/volume.h"
#include "core/fields/settings.h"
#include "core/glance/trails.h"
#include "core/scene/overlay.h"
#include "core/scene/slices.h"
#include "core/scene/theme.h"
#include "gl/framebuffer.h"

namespace vvr::app {

namespace {

// A clip in which a point moves, of sizes that are no powers of two, like most: Mesa makes other shaders for those.
constexpr Size rehearsed_size{6, 6};
constexpr int rehearsed_frames = 5;

bricks::Volume warm_up_volume(gl::VolumeColour colour) {
    bricks::Volume volume(rehearsed_size, rehearsed_frames);
    if (colour == gl::VolumeColour::object) volume.keep_owners();
    const Plane<Bgr> picture = colour == gl::VolumeColour::own ? Plane<Bgr>(rehearsed_size) : Plane<Bgr>();
    for (int i = 0; i < rehearsed_frames; ++i) {
        fields::Field field{i, i / 25.0, Plane<std::uint8_t>(rehearsed_size), {}, {{2, 2, 1, 1}}};
        field.scalar.at(2, 2) = 255;
        volume.add(field, picture);
    }
    return volume;
}

}  // namespace

void open_context(const RenderJob& job, Drawing& drawing, Observer& observer) {
    const auto warn = [&observer](const std::string& text) { observer.warn(text); };
    drawing.context = gl::open_context(job.backend.row, job.backend.device,
                                       job.backend.debug ? gl::DriverMessages(warn) : gl::DriverMessages());
    gl::check_samples(drawing.context->gl(), job.picture.samples);
}

void make_renderer(const RenderJob& job, Size field_size, std::int64_t tile_samples, Drawing& drawing) {
    drawing.layout = layout_of(job, field_size);
    drawing.framing = frame_volume(job, *drawing.layout, static_cast<double>(field_size.width) / field_size.height);
    gl::RenderOptions options = job.picture;
    options.camera = drawing.framing.camera;
    options.background = background_of(job.look);
    options.glyphs = glyph_style_of(job);
    options.tile_samples = tile_samples;
    drawing.renderer = std::make_unique<gl::Renderer>(*drawing.context, *drawing.layout, options);
    drawing.renderer->set_transfer(drawn_transfer_of(job.look));
    if (job.picture.colour == gl::VolumeColour::object)
        drawing.renderer->set_palette(scene::object_palette(job.look.theme));
    if (job.picture.colour == gl::VolumeColour::time) drawing.renderer->set_palette(scene::time_colours());
}

double half_pixel(const RenderJob& job, const Drawing& drawing) {
    double side = 0;
    for (const glm::dvec3& p : scene::outline_points(*drawing.layout))
        side = std::max(side, drawing.framing.camera.pixel_side(p, job.picture.size));
    return side * std::numbers::sqrt2 / 2;
}

void warm_up(const RenderJob& job, const Drawing& drawing) {
    const bricks::Volume volume = warm_up_volume(job.picture.colour);
    const video::Frame frame{0, 0, Plane<std::uint8_t>(rehearsed_size), {}};
    gl::BrickWindow window(drawing.context->gl(), *drawing.layout, rehearsed_frames, 1);
    if (job.look.show.has(Part::volume)) window.show(volume, bricks::cut_into(rehearsed_frames, 1));
    gl::Renderer& renderer = *drawing.renderer;
    renderer.set_scene(build_scene(job, volume, {frame, frame}, *drawing.layout, drawing.framing, {}, {}));
    renderer.warm_up(window);
}

void describe(const fields::FieldSource& source, const gl::Context& context, RenderReport& report) {
    report.info = source.info();
    report.field_size = source.field_size();
    report.renderer = context.renderer();
    report.gl_version = context.version();
    report.backend = context.backend();
    report.stages.end("context");
}

fields::FieldNeeds needs_of(const RenderJob& job, const fields::FieldSource& source, std::int64_t frames) {
    constexpr std::int64_t arrow_times = 80;  // along the arc; more would hide each other
    fields::FieldNeeds needs;
    needs.flow = job.look.show.any(&PartRow::needs_flow);
    needs.seeds = job.look.show.any(&PartRow::needs_seeds);
    // Objects are told apart by their colours where these are there.
    const ColourRow& colour = *job.look.colour;
    needs.flow_of_every_frame = colour.needs_flow;
    const bool stand = job.look.show.has(Part::frames) && job.look.keyframes > 0;
    needs.colour = colour.needs_pictures || (stand && source.has_pictures()) ||
                   (job.picture.colour == gl::VolumeColour::object && source.has_pictures());
    // Frames are what a header says, or times that are years apart: nobody asked for such an interval.
    constexpr auto most = static_cast<std::int64_t>(setting::flow_every.range.high);
    needs.every = std::min(most, source.interval(std::clamp<std::int64_t>(frames / arrow_times, 1, most)));
    return needs;
}

std::unique_ptr<space::Layout> layout_of(const RenderJob& job, Size field_size) {
    return space::make_layout(job.layout, space::shape_for(field_size, job.shape));
}

std::int64_t layer_of(const KeyFrame& key, const bricks::Volume& volume) {
    return key.number / volume.step();
}

std::vector<bricks::Brick> sub_bricks_of(std::span<const bricks::Brick> bricks, std::span<const KeyFrame> between,
                                         const bricks::Volume& volume) {
    std::vector<std::int64_t> layers;
    for (const KeyFrame& key : between) layers.push_back(layer_of(key, volume));
    return bricks::cut_into_sub_bricks(bricks::cut_at(bricks, layers));
}

scene::Scene build_scene(const RenderJob& job, const bricks::Volume& volume, const WindowFrames& frames,
                         const space::Layout& layout, const Framing& framing,
                         const std::vector<labels::TimeTick>& ticks, const glance::Objects& objects,
                         const bricks::Identify& identify) {
    scene::Scene scene;
    const std::vector<bricks::FrameSeed> seeds =
        bricks::used_seeds(volume, frames.bricks, frames.first_brick, job.seed_flags);
    if (job.look.show.has(Part::arrows))
        scene.arrows = scene::arrows(volume, seeds, layout, glyph_options_of(job.look));
    if (job.look.show.has(Part::directions)) {
        const double length = 1.5 * glyph_options_of(job.look).cap;
        const std::vector<scene::Glyph> along = glance::direction_arrows(objects, volume, layout, length);
        scene.arrows.insert(scene.arrows.end(), along.begin(), along.end());
    }
    if (job.look.show.has(Part::tracelines))
        scene.tracelines = scene::tracelines(volume, seeds, layout, job.look.traces);
    const glm::vec4 line_colour(job.look.theme.lines, 1);
    if (job.look.show.has(Part::outline)) scene.lines = scene::volume_outline(layout, line_colour);
    const auto add_lines = [&scene](const std::vector<scene::LineSegment>& lines) {
        scene.lines.insert(scene.lines.end(), lines.begin(), lines.end());
    };
    add_lines(labels::ruler_marks(volume, layout, framing.edge, ticks, line_colour));
    if (job.look.show.has(Part::ribs)) {
        // Pale, not transparent: lines hide what is behind them, so that these are in the volume and not before it.
        const glm::vec4 pale = glm::mix(line_colour, background_of(job.look), 0.55F);
        for (const labels::TimeTick& tick : ticks)
            add_lines(scene::cross_section(layout, volume.t_of_seconds(tick.seconds), pale));
        const labels::TimeEdge inner{1 - framing.edge.x, framing.edge.y};
        add_lines(labels::ruler_marks(volume, layout, inner, ticks, line_colour));
    }
    if (job.look.show.has(Part::ruler)) {
        add_lines(labels::break_marks(labels::time_breaks(volume, breaks_shown), layout, framing.edge, line_colour));
        add_lines(
            labels::gap_marks(labels::time_gaps(volume), layout, framing.edge, glm::vec4(job.look.theme.fast, 1)));
    }
    if (job.look.show.has(Part::floor)) {
        scene.floor = volume.keeps_owners() ? scene::floor_shadow(volume, job.look.theme, identify)
                                            : scene::floor_shadow(volume, job.look.theme.shadow);
    }
    if (job.look.show.has(Part::frames)) {
        constexpr float at_the_ends = 0.5F;
        constexpr float between = 0.3F;  // they hide what is behind them
        const auto stand = [&scene](double t, const video::Frame& frame, std::int64_t number, float opacity) {
            Plane<Bgr> picture = video::picture_of(frame);
            if (!picture.empty()) scene.frames.push_back({t, std::move(picture), opacity, static_cast<double>(number)});
        };
        stand(0, frames.first, 0, at_the_ends);
        for (const KeyFrame& key : frames.between) {
            // Where its layer begins: there a piece of the volume ends, so that one of them hides the other.
            stand(volume.t_of_layer(layer_of(key, volume)), *key.frame, key.number, between);
        }
        stand(volume.t_end(), frames.last, volume.frames() - 1, at_the_ends);
    }
    return scene;
}

void add_overlays(const RenderJob& job, const Drawing& drawing, std::span<const bricks::Brick> bricks,
                  std::int64_t window_layers, scene::Scene& scene) {
    const space::Layout& layout = *drawing.layout;
    const auto add = [&scene](const std::vector<scene::LineSegment>& lines) {
        scene.lines.insert(scene.lines.end(), lines.begin(), lines.end());
    };
    if (job.look.show.has(Part::bricks)) {
        for (const bricks::Brick& brick : bricks) {
            const double t = static_cast<double>(brick.first) / static_cast<double>(window_layers);
            if (t > 0) add(scene::cross_section(layout, t, glm::vec4(job.look.theme.lines, 0.5)));
        }
    }
    const scene::BoundingBox rendered =
        scene::visible_bounds(drawing.window->cells(), layout, drawn_transfer_of(job.look));
    if (job.look.show.has(Part::boxes)) {
        add(scene::box_edges(scene::layout_bounds(layout), {0.13F, 0.35F, 0.85F, 1}));
        add(scene::box_edges(rendered, {0.88F, 0.68F, 0.05F, 1}));
    }
    if (job.look.show.has(Part::slices)) {
        constexpr int shown = 20;
        const gl::Renderer& renderer = *drawing.renderer;
        const space::Camera camera =
            job.look.slice_view
                ? space::fit_camera(*job.look.slice_view, scene::outline_points(layout), job.picture.size)
                : renderer.camera();
        const scene::SliceStack stack = renderer.slices(*drawing.window, camera);
        add(scene::slice_outlines(rendered, camera, stack, shown, {0.10F, 0.62F, 0.22F, 1}));
    }
}

bool nothing_visible(const bricks::Volume& volume, const scene::TransferFunction& transfer) {
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        if (transfer.visible({0, volume.layer(i).scalar.greatest()})) return false;
    }
    return true;
}

image::Picture draw_picture(bool pixel_data, Drawing& drawing, const bricks::Volume& volume,
                            const labels::Lettering& lettering, double phase) {
    image::Picture picture = image::to_picture(drawing.renderer->draw(*drawing.window, phase));
    if (pixel_data) picture.pixel_data = drawing.renderer->draw_pixel_data(*drawing.window, scene::TimeTable(volume));
    labels::draw(picture, lettering);
    return picture;
}

RenderThread::RenderThread() {
    tasks_.set_capacity(1);
    thread_ = std::jthread([this] { serve(); });
}

RenderThread::~RenderThread() {
    tasks_.push({});
}

std::future<void> RenderThread::start(Work work) {
    Task task([this, work = std::move(work)](Drawing& drawing) {
        if (error_) std::rethrow_exception(error_);
        try {
            work(drawing);
        } catch (...) {
            error_ = std::current_exception();
            throw;
        }
    });
    auto done = task.get_future();
    tasks_.push(std::move(task));
    return done;
}

void RenderThread::serve() {
    Drawing drawing;
    Task task;
    for (tasks_.pop(task); task.valid(); tasks_.pop(task)) task(drawing);
}

}  // namespace vvr::app
