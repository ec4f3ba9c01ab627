#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include <sys/types.h>

#include "cli/signals.h"
#include "cli/workers/sandbox.h"
#include "cli/workers/worker_message.h"

namespace vvr::workers {

/// What a worker may take. 0 = as much as it likes.
struct WorkerLimits {
    std::chrono::seconds time{0};
    std::int64_t memory = 0;   ///< bytes
    std::int64_t file = 0;     ///< bytes of the largest file
    std::int64_t written = 0;  ///< bytes of all that it writes; nothing is held where the kernel doesn't count them
};

/// How a worker ended.
struct WorkerResult {
    int status = 0;               ///< exit status, or 128 + the signal, as a shell shows it
    bool began = false;           ///< it was a worker: nothing that comes after that undoes it
    bool timed_out = false;       ///< and was killed for it
    bool wrote_too_much = false;  ///< and was killed for it
    WorkerMessage told;           ///< what it says of its run; empty where it did not get so far
    std::string said;             ///< the end of what it wrote to stderr, for people
    double seconds = 0;
};

/// A child that runs this very program with a plan, in a process group of its own. It ends when this process
/// does, however that comes about.
class Worker {
  public:
    /// \param threads for libraries that can't be told by a setting
    /// \param inherited a descriptor that it keeps open as long as it lives; -1 = none
    /// \throws Error limit when the system can't start a process
    Worker(const WorkerPlan& plan, int threads, const WorkerLimits& limits, int inherited,
           const Confinement& confinement);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// To wait on: it can be read when the worker has said something, or has ended.
    int descriptor() const { return output_; }

    /// Takes in what there is to be read, and kills the worker if its time is over.
    /// \returns whether it has ended
    bool update();

    /// Asks the worker to end.
    void interrupt();

    const WorkerResult& end() const { return end_; }

  private:
    using Clock = std::chrono::steady_clock;

    void kill() const;
    void read_output();
    void read_message();
    void reap(bool wait);
    void enforce_limits();
    std::int64_t written() const;

    pid_t process_ = -1;
    int output_ = -1;
    int told_ = -1;
    bool ended_ = false;
    Clock::time_point began_ = Clock::now();
    WorkerLimits limits_;
    WorkerResult end_;
};

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
