#pragma once

#include <exception>
#include <functional>
#include <future>
#include <thread>
#include <utility>

#include <oneapi/tbb/concurrent_queue.h>

#include "cli/app/draw.h"

namespace vvr::app {

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
