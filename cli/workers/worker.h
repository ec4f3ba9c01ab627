#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

#include "cli/signals.h"
#include "cli/workers/sandbox.h"
#include "cli/workers/worker_message.h"

namespace vvr::workers {

/// Limits of a worker. 0 = unlimited.
struct WorkerLimits {
    std::chrono::seconds time{0};
    std::int64_t memory = 0;   ///< bytes
    std::int64_t file = 0;     ///< bytes of the largest file
    std::int64_t written = 0;  ///< bytes written in total; not enforced where the kernel doesn't count them
};

/// How a worker ended.
struct WorkerResult {
    int status = 0;               ///< exit status, or 128 + signal number, as in a shell
    bool began = false;           ///< it got as far as begin_worker
    bool timed_out = false;       ///< and was killed for that
    bool wrote_too_much = false;  ///< and was killed for that
    WorkerMessage message;        ///< its message; empty if it sent none
    std::string stderr_end;       ///< the end of its stderr, for people
    double seconds = 0;
};

/// A child process that runs this program with a plan, in its own process group. The kernel kills it when this process
/// ends, however that happens.
class Worker {
  public:
    /// \param threads for libraries that have no setting for it
    /// \param inherited a file descriptor that the child keeps open while it lives; -1 = none
    /// \throws Error limit when the system can't start a process
    Worker(const WorkerPlan& plan, int threads, const WorkerLimits& limits, int inherited,
           const Confinement& confinement);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// For poll(): readable when the worker has written to stderr or has ended.
    int descriptor() const { return output_; }

    /// Reads the worker's output, and kills the worker if it is over a limit.
    /// \returns whether it has ended
    bool update();

    /// Sends SIGTERM to the worker's process group.
    void interrupt();

    /// Which part of its frames it says to have read, 0 to 1.
    double progress() const;

    const WorkerResult& end() const { return end_; }

  private:
    using Clock = std::chrono::steady_clock;

    void kill() const;
    void read_output();
    void read_message();
    std::size_t marks() const;
    void reap(bool wait);
    void enforce_limits();
    std::int64_t written() const;

    pid_t process_ = -1;
    int output_ = -1;
    int message_pipe_ = -1;
    std::string message_;  ///< what came from `message_pipe_`
    bool ended_ = false;
    Clock::time_point began_ = Clock::now();
    WorkerLimits limits_;
    WorkerResult end_;
};

/// Runs up to a given number of workers at a time. A signal ends them before it ends the program.
class WorkerPool {
  public:
    /// Called when a worker has ended.
    using Done = std::function<void(const WorkerResult&)>;

    WorkerPool(int most, cli::Signals& signals);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    void add(std::unique_ptr<Worker> worker, Done done);

    /// Sets a function that is called several times a second while workers run.
    void set_tick(std::function<void()> tick) { tick_ = std::move(tick); }

    /// Waits until another worker can start.
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
    std::function<void()> tick_{};
    int wake_;  ///< eventfd, written when a signal arrives
    std::atomic<bool> ending_ = false;
    std::atomic<bool> ended_ = false;
};

}  // namespace vvr::workers
