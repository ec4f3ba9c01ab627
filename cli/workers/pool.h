#pragma once

#include <atomic>
#include <functional>
#include <list>
#include <memory>

#include "cli/signals.h"
#include "cli/workers/worker.h"

namespace vvr::workers {

/// Workers at work, so many at a time. A signal ends them before it ends the program.
class WorkerPool {
  public:
    /// Told of a worker's end.
    using Done = std::function<void(const WorkerResult&)>;

    WorkerPool(int most, cli::Signals& signals);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    void add(std::unique_ptr<Worker> worker, Done done);

    /// Waits until there is room for one more.
    void wait_for_room() { wait_until_below(most_); }

    void wait_for_all() { wait_until_below(1); }

  private:
    struct Job {
        std::unique_ptr<Worker> worker;
        Done done;
    };

    void wait_until_below(int count);
    void sleep() const;
    [[noreturn]] void end_all();

    int most_;
    cli::Signals& signals_;
    std::list<Job> jobs_;
    int wake_;  ///< an eventfd: a signal has come
    std::atomic<bool> ending_ = false;
    std::atomic<bool> ended_ = false;
};

}  // namespace vvr::workers
