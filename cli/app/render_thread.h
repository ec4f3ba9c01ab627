#pragma once

#include <exception>
#include <functional>
#include <future>
#include <thread>
#include <utility>

#include <oneapi/tbb/concurrent_queue.h>

#include "cli/app/draw.h"

namespace vvr::app {

/// The thread that draws. OpenGL is opened, used and closed on it only. Other threads give it work, which it does in
/// order. After the first error, all later work fails with the same error.
class RenderThread {
  public:
    using Work = std::function<void(Drawing&)>;

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
    using Task = std::packaged_task<void(Drawing&)>;

    void serve();

    oneapi::tbb::concurrent_bounded_queue<Task> tasks_;  ///< an empty task ends the thread
    std::exception_ptr error_;                           ///< the first error; used by the thread only
    std::jthread thread_;
};

}  // namespace vvr::app
