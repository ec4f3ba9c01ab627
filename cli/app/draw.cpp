#include "cli/app/draw.h"

#include <utility>

#include "core/base/memory.h"
#include "core/scene/scene.h"
#include "core/scene/slices.h"
#include "gl/framebuffer.h"

namespace vvr::app {

namespace {

/// A clip in which a point moves. As in most clips, its size is no power of two: Mesa compiles different shaders for
/// those.
Observation warm_up_observation(const Plan& plan) {
    constexpr Size size{6, 6};
    constexpr int frames = 5;
    Observation seen{volume::Volume(size, {.capacity = frames, .keep_owners = plan.colours_objects()})};
    const bool coloured = plan.colour->drawn == gl::VolumeColour::own;
    for (int i = 0; i < frames; ++i) {
        fields::Field field{i, i / 25.0, Plane<std::uint8_t>(size), {}, {{2, 2, 1, 1}}};
        field.scalar.at(2, 2) = 255;
        seen.volume.add(field, coloured ? Plane<Bgr>(size) : Plane<Bgr>());
    }
    seen.first = seen.last = std::make_shared<const media::Frame>(media::Frame{0, 0, Plane<std::uint8_t>(size), {}});
    return seen;
}

/// Fig. 5: adds the lines that the renderer computes from the bricks.
void add_overlays(const Plan& plan, const Composition& composed, const Drawing& drawing, scene::Scene& scene) {
    if (!composed.boxes && !composed.slices) return;
    const auto add = [&scene](const std::vector<scene::LineSegment>& lines) {
        scene.lines.insert(scene.lines.end(), lines.begin(), lines.end());
    };
    const scene::BoundingBox rendered =
        scene::visible_bounds(drawing.window->cells(), *plan.layout, plan.drawn_transfer);
    if (composed.boxes) {
        add(scene::box_edges(scene::layout_bounds(*plan.layout), {0.13F, 0.35F, 0.85F, 1}));
        add(scene::box_edges(rendered, {0.88F, 0.68F, 0.05F, 1}));
    }
    if (composed.slices) {
        constexpr int shown = 20;
        const scene::SliceStack stack = drawing.renderer->slices(*drawing.window, *composed.slices);
        add(scene::slice_outlines(rendered, *composed.slices, stack, shown, {0.10F, 0.62F, 0.22F, 1}));
    }
}

}  // namespace

void open_context(const Plan& plan, Drawing& drawing, Observer& observer) {
    const BackendOptions& backend = plan.job.backend;
    const auto warn = [&observer](const std::string& text) { observer.warn(text); };
    drawing.context =
        gl::open_context(backend.row, backend.device, backend.debug ? gl::DriverMessages(warn) : gl::DriverMessages());
    gl::check_samples(drawing.context->gl(), plan.picture.samples);
}

void make_renderer(const Plan& plan, std::int64_t tile_samples, Drawing& drawing) {
    gl::RenderOptions options = plan.picture;
    options.camera = plan.framing().camera;
    options.tile_samples = tile_samples;
    drawing.renderer = std::make_unique<gl::Renderer>(*drawing.context, *plan.layout, options);
    drawing.renderer->set_transfer(plan.drawn_transfer);
    const std::vector<glm::vec4> palette = palette_of(plan);
    if (!palette.empty()) drawing.renderer->set_palette(palette);
}

void warm_up(const Plan& plan, const Drawing& drawing) {
    const Observation seen = warm_up_observation(plan);
    Composition composed;
    composed.framing = plan.framing();
    gl::BrickWindow window(drawing.context->gl(), *plan.layout, seen.volume.layers(), 1);
    if (plan.shows(Part::volume)) window.show(seen.volume, volume::cut_into(seen.volume.layers(), 1));
    drawing.renderer->set_scene(scene_of(plan, seen, composed));
    drawing.renderer->warm_up(window);
}

void show(const Plan& plan, Composition& composed, const Observation& seen, Drawing& drawing) {
    if (!drawing.window) {
        drawing.window = std::make_unique<gl::BrickWindow>(drawing.context->gl(), *plan.layout, composed.layers,
                                                           composed.textures, composed.framing.half_pixel);
    }
    drawing.window->show(seen.volume, composed.pieces, composed.first_piece, seen.identify);
    if (!composed.palette.empty()) drawing.renderer->set_palette(composed.palette);
    add_overlays(plan, composed, drawing, composed.scene);
    drawing.renderer->set_scene(std::move(composed.scene));
}

image::Picture draw(const Plan& plan, const Observation& seen, Drawing& drawing, Observer& observer, double phase) {
    const std::size_t passes = plan.products.pixel_data ? 2 : 1;
    const auto tell = [&](std::size_t pass) {
        return [&observer, pass, passes](std::size_t done, std::size_t tiles) {
            observer.drawing(static_cast<std::int64_t>(pass * tiles + done), static_cast<std::int64_t>(passes * tiles));
        };
    };
    image::Picture picture = image::to_picture(drawing.renderer->draw(*drawing.window, phase, tell(0)));
    if (plan.products.pixel_data) {
        picture.pixel_data = drawing.renderer->draw_pixel_data(*drawing.window, scene::TimeTable(seen.volume), tell(1));
    }
    return picture;
}

void close(Drawing& drawing) {
    { const Drawing closed = std::move(drawing); }
    trim_heap();
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
