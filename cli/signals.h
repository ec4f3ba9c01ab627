#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace vvr::cli {

/// SIGINT, SIGTERM and SIGHUP end the program at once, except while a file is being written: then they wait for it.
/// So a file is whole or not there. A signal that whoever started vvr ignores stays ignored.
///
/// Has to be made before any other thread. SIGPIPE and SIGXFSZ become errors of the write that caused them.
class Signals {
  public:
    Signals();
    ~Signals();
    Signals(const Signals&) = delete;
    Signals& operator=(const Signals&) = delete;

    /// Signals wait until the lock is gone.
    [[nodiscard]] std::unique_lock<std::mutex> hold() { return std::unique_lock(writing_); }

    /// What a signal calls before it ends the program, on a thread of its own; an empty function takes it back.
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

/// While it lives, the first signal calls `stop`, on another thread, and the program goes on; the next one ends it.
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

    /// Whether there was a signal.
    bool asked() const { return asked_; }

  private:
    Signals& signals_;
    std::atomic<bool> asked_ = false;
};

}  // namespace vvr::cli
