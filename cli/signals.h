#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace vvr::cli {

/// SIGINT, SIGTERM and SIGHUP end the program at once, but not while a file is being written, so a file is complete or
/// absent. Signals that vvr inherits as ignored stay ignored. SIGPIPE and SIGXFSZ become errors of the failing
/// write.
///
/// Create it before any other thread.
class Signals {
  public:
    Signals();
    ~Signals();
    Signals(const Signals&) = delete;
    Signals& operator=(const Signals&) = delete;

    /// Holds signals back while the lock exists.
    [[nodiscard]] std::unique_lock<std::mutex> hold() { return std::unique_lock(writing_); }

    /// Sets the function that runs before a signal ends the program, on another thread; an empty function removes it.
    void set_exit_hook(std::function<void()> exit_hook);

  private:
    friend class GracefulShutdown;

    void set_stop_handler(std::function<void()> stop);
    bool stop_gracefully();
    void wait(const std::stop_token& stop);

    sigset_t set_{};
    std::mutex writing_;
    std::mutex stopping_;
    std::function<void()> stop_;
    std::mutex ending_;
    std::function<void()> exit_hook_;
    std::jthread waiter_;
};

/// Runs `work`. When a signal arrives, `work` is asked to stop; once it has removed its unfinished files and returned
/// false, the signal ends the program.
void run_stoppable(Signals& signals, const std::function<bool(const std::stop_token& stop)>& work);

/// While it exists, the first signal calls `stop` on another thread and the program goes on; the second signal ends it.
class GracefulShutdown {
  public:
    GracefulShutdown(Signals& signals, std::function<void()> stop) : signals_(signals) {
        signals_.set_stop_handler([this, stop = std::move(stop)] {
            asked_ = true;
            stop();
        });
    }
    ~GracefulShutdown() { signals_.set_stop_handler({}); }
    GracefulShutdown(const GracefulShutdown&) = delete;
    GracefulShutdown& operator=(const GracefulShutdown&) = delete;

    /// Whether a signal has arrived.
    bool asked() const { return asked_; }

  private:
    Signals& signals_;
    std::atomic<bool> asked_ = false;
};

}  // namespace vvr::cli
