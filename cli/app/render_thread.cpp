#include "cli/app/render_thread.h"

namespace vvr::app {

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
