#include "cli/draw/draw.h"

#include "core/base/memory.h"
#include "core/scene/scene.h"
#include "core/scene/slices.h"
#include "gl/framebuffer.h"

namespace vvr::app {

namespace {

/// Fig. 5: adds the lines that the renderer computes from the bricks.
void add_overlays(const LookPlan& look, const Composition& composed, const GlSession& session, scene::Scene& scene) {
    if (!composed.boxes && !composed.slices) return;
    const auto add = [&scene](const std::vector<scene::LineSegment>& lines) {
        scene.lines.insert(scene.lines.end(), lines.begin(), lines.end());
    };
    const scene::BoundingBox rendered =
        scene::visible_bounds(session.window->cells(), *look.layout, look.drawn_transfer);
    if (composed.boxes) {
        add(scene::box_edges(scene::layout_bounds(*look.layout), {0.13F, 0.35F, 0.85F, 1}));
        add(scene::box_edges(rendered, {0.88F, 0.68F, 0.05F, 1}));
    }
    if (composed.slices) {
        constexpr int shown = 20;
        const scene::SliceStack stack = session.renderer->slices(*session.window, *composed.slices);
        add(scene::slice_outlines(rendered, *composed.slices, stack, shown, {0.10F, 0.62F, 0.22F, 1}));
    }
}

}  // namespace

void open_context(const LookPlan& look, GlSession& session, Observer& observer) {
    const BackendOptions& backend = look.backend;
    const auto warn = [&observer](const std::string& text) { observer.warn(text); };
    session.context =
        gl::open_context(backend.row, backend.device, backend.debug ? gl::DriverMessages(warn) : gl::DriverMessages());
    gl::check_samples(session.context->gl(), look.picture.samples);
}

void make_renderer(const LookPlan& look, std::int64_t tile_samples, GlSession& session) {
    gl::RenderOptions options = look.picture;
    options.camera = look.framing().camera;
    options.tile_samples = tile_samples;
    session.renderer = std::make_unique<gl::Renderer>(*session.context, *look.layout, options);
    session.renderer->set_transfer(look.drawn_transfer);
    const std::vector<glm::vec4> palette = palette_of(look);
    if (!palette.empty()) session.renderer->set_palette(palette);
}

void warm_up(const LookPlan& look, const Composition& composed, const Observation& seen, const GlSession& session) {
    gl::BrickWindow window(session.context->gl(), *look.layout, composed.layers, 1);
    if (!composed.pieces.empty()) window.show(seen.volume, composed.pieces);
    session.renderer->set_scene(composed.scene);
    session.renderer->warm_up(window);
}

void show(const LookPlan& look, const Composition& composed, const Observation& seen, GlSession& session) {
    if (!session.window) {
        session.window = std::make_unique<gl::BrickWindow>(session.context->gl(), *look.layout, composed.layers,
                                                           composed.textures, composed.framing.half_pixel);
    }
    session.window->show(seen.volume, composed.pieces, composed.first_piece, seen.identify);
    if (!composed.palette.empty()) session.renderer->set_palette(composed.palette);
    scene::Scene scene = composed.scene;
    add_overlays(look, composed, session, scene);
    session.renderer->set_scene(std::move(scene));
}

image::Picture draw(const LookPlan& look, const Observation& seen, GlSession& session, Observer& observer,
                    double phase) {
    const std::size_t passes = look.pixel_data ? 2 : 1;
    const auto tell = [&](std::size_t pass) {
        return [&observer, pass, passes](std::size_t done, std::size_t tiles) {
            observer.drawing(static_cast<std::int64_t>(pass * tiles + done), static_cast<std::int64_t>(passes * tiles));
        };
    };
    image::Picture picture = image::to_picture(session.renderer->draw(*session.window, phase, tell(0)));
    if (look.pixel_data) {
        picture.pixel_data = session.renderer->draw_pixel_data(*session.window, scene::TimeTable(seen.volume), tell(1));
    }
    return picture;
}

void close(GlSession& session) {
    { const GlSession closed = std::move(session); }
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
    Task task([this, work = std::move(work)](GlSession& session) {
        if (error_) std::rethrow_exception(error_);
        try {
            work(session);
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
    GlSession session;
    Task task;
    for (tasks_.pop(task); task.valid(); tasks_.pop(task)) task(session);
}

}  // namespace vvr::app
