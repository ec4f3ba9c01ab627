#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include <oneapi/tbb/concurrent_queue.h>

#include "cli/compose/compose.h"
#include "cli/plan/observer.h"
#include "cli/plan/plan.h"
#include "core/image/picture.h"
#include "gl/context.h"
#include "gl/renderer.h"

// Draws compositions, on a thread that owns the OpenGL context: call these functions on a RenderThread.
namespace vvr::app {

/// The OpenGL objects that draw the pictures of a plan. Create, use and close them on the same thread.
struct GlSession {
    std::shared_ptr<gl::Context> context;
    std::unique_ptr<gl::Renderer> renderer;
    std::unique_ptr<gl::BrickWindow> window;
};

/// Opens a context that can draw the plan. Close it before the observer is destroyed.
/// \throws Error backend, limit
void open_context(const LookPlan& look, GlSession& session, Observer& observer);

/// Creates everything that does not depend on the clip's fields. The session must have a context.
/// \param tile_samples as in RenderOptions: a larger number uses more memory
/// \throws Error backend, limit, io
void make_renderer(const LookPlan& look, std::int64_t tile_samples, GlSession& session);

/// Draws something small, so that the shaders are compiled before the first real picture. The session must have a
/// renderer.
/// \param composed from compose_sample
void warm_up(const LookPlan& look, const Composition& composed, const Observation& seen, const GlSession& session);

/// Passes a composition to the renderer, for the pictures that follow.
/// \param seen with the volume that was composed; it must not change until they are drawn
void show(const LookPlan& look, const Composition& composed, const Observation& seen, GlSession& session);

/// Draws the current composition without its lettering.
/// \param observer receives the progress
/// \param phase of the texture that moves along the tracelines, 0..1
image::Picture draw(const LookPlan& look, const Observation& seen, GlSession& session, Observer& observer,
                    double phase = 0);

/// Releases OpenGL's memory, before encoding needs as much.
void close(GlSession& session);

/// The thread that draws. OpenGL is opened, used and closed on it only. Other threads give it work, which it does in
/// order. After the first error, all later work fails with the same error.
class RenderThread {
  public:
    using Work = std::function<void(GlSession&)>;

    RenderThread();

    /// Waits until all work is done.
    ~RenderThread();
    RenderThread(const RenderThread&) = delete;
    RenderThread& operator=(const RenderThread&) = delete;

    /// Queues work. Blocks while the queue is full.
    /// \returns a future that is ready when the work is done, or has its exception
    std::future<void> start(Work work);

    /// Runs work on the thread and waits for it.
    void run(Work work) { start(std::move(work)).get(); }

  private:
    using Task = std::packaged_task<void(GlSession&)>;

    void serve();

    oneapi::tbb::concurrent_bounded_queue<Task> tasks_;  ///< an empty task ends the thread
    std::exception_ptr error_;                           ///< the first error; used by the thread only
    std::jthread thread_;
};

}  // namespace vvr::app
