#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <span>
#include <thread>

#include <oneapi/tbb/concurrent_queue.h>

#include "cli/app/compose.h"
#include "cli/app/job.h"
#include "cli/app/observer.h"
#include "cli/app/report.h"
#include "core/bricks/owners.h"
#include "core/fields/field_source.h"
#include "core/scene/scene.h"
#include "core/video/frame.h"
#include "gl/context.h"
#include "gl/renderer.h"

namespace vvr::app {

/// What draws the pictures of a job. It is made, used and closed on one thread (cli/app/render_thread.h).
struct Drawing {
    std::shared_ptr<gl::Context> context;
    std::unique_ptr<space::Layout> layout;
    Framing framing;
    std::unique_ptr<gl::Renderer> renderer;
    std::unique_ptr<gl::BrickWindow> window;
};

/// Opens a context that can draw what the job asks for. It is closed before the observer goes.
/// \throws Error backend, limit
void open_context(const RenderJob& job, Drawing& drawing, Observer& observer);

/// Makes all that does not depend on the clip's fields, in a drawing that has a context.
/// \param tile_samples as in RenderOptions: more take more memory
/// \throws Error backend, limit, io
void make_renderer(const RenderJob& job, Size field_size, std::int64_t tile_samples, Drawing& drawing);

/// Half of the diagonal of the largest pixel that shows the volume, in P-space units: the margin of a BrickWindow's
/// cells.
double half_pixel(const RenderJob& job, const Drawing& drawing);

/// Draws something small, so that the first real picture finds its shaders compiled. The drawing has a renderer.
void warm_up(const RenderJob& job, const Drawing& drawing);

}  // namespace vvr::app

// The steps from a volume to its picture that one picture of a clip and a series of them share.
namespace vvr::app {

/// A frame and its number, counted from the volume's first.
struct KeyFrame {
    video::SharedFrame frame;
    std::int64_t number = 0;
};

/// The frames at the ends of a volume and between them; one without a picture is not drawn. And its bricks.
struct WindowFrames {
    const video::Frame& first;
    const video::Frame& last;
    std::span<const KeyFrame> between{};
    std::span<const bricks::Brick> bricks{};
    std::int64_t first_brick = 0;  ///< its number, counted from the clip's first
};

/// The layer at whose beginning a key frame stands.
std::int64_t layer_of(const KeyFrame& key, const bricks::Volume& volume);

/// The pieces that bricks are drawn in: they end where a key frame stands.
std::vector<bricks::Brick> sub_bricks_of(std::span<const bricks::Brick> bricks, std::span<const KeyFrame> between,
                                         const bricks::Volume& volume);

/// Reports the source and the context.
void describe(const fields::FieldSource& source, const gl::Context& context, RenderReport& report);

/// What a picture of `frames` frames needs of the fields.
fields::FieldNeeds needs_of(const RenderJob& job, const fields::FieldSource& source, std::int64_t frames);

std::unique_ptr<space::Layout> layout_of(const RenderJob& job, Size field_size);

/// All geometry that depends on the fields alone.
/// \param ticks of the ruler
/// \param identify of a volume that keeps owners
scene::Scene build_scene(const RenderJob& job, const bricks::Volume& volume, const WindowFrames& frames,
                         const space::Layout& layout, const Framing& framing,
                         const std::vector<labels::TimeTick>& ticks, const glance::Objects& objects,
                         const bricks::Identify& identify = bricks::no_identities);

/// Fig. 5: what the renderer makes of the bricks.
/// \param drawing its window shows them
/// \param window_layers that fill all of t_C
void add_overlays(const RenderJob& job, const Drawing& drawing, std::span<const bricks::Brick> bricks,
                  std::int64_t window_layers, scene::Scene& scene);

bool nothing_visible(const bricks::Volume& volume, const scene::TransferFunction& transfer);

/// Draws the window of the drawing and its scene, and writes on it.
/// \param pixel_data whether the picture comes with what each pixel shows
/// \param phase of the texture that moves along the tracelines, 0..1
image::Picture draw_picture(bool pixel_data, Drawing& drawing, const bricks::Volume& volume,
                            const labels::Lettering& lettering, double phase = 0);

/// The thread that draws. It owns a drawing: OpenGL is opened, used and closed there, whichever threads ask for
/// pictures. Work is done in the order in which it is given. After the first error no more work is done: each later one
/// fails with the same error.
class RenderThread {
  public:
    using Work = std::function<void(Drawing&)>;

    RenderThread();

    /// Waits for the work that has been given.
    ~RenderThread();
    RenderThread(const RenderThread&) = delete;
    RenderThread& operator=(const RenderThread&) = delete;

    /// Gives the thread work to do. Waits while other work waits.
    /// \returns when it has been done; throws what the work has thrown
    std::future<void> start(Work work);

    /// Does work on the thread, and waits for it.
    void run(Work work) { start(std::move(work)).get(); }

  private:
    using Task = std::packaged_task<void(Drawing&)>;

    void serve();

    oneapi::tbb::concurrent_bounded_queue<Task> tasks_;  ///< an empty task ends the thread
    std::exception_ptr error_;                           ///< the first; only the thread looks at it
    std::jthread thread_;
};

}  // namespace vvr::app
