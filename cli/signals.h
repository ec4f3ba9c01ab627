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
    void before_end(std::function<void()> last_words);

  private:
    friend class PoliteStop;

    void stop_with(std::function<void()> stop);
    bool stop_politely();
    void wait(const std::stop_token& stop);

    sigset_t set_{};
    std::mutex writing_;
    std::mutex stopping_;
    std::function<void()> stop_;
    std::mutex ending_;
    std::function<void()> last_words_;
    std::jthread waiter_;
};

/// While it lives, the first signal calls `stop`, on another thread, and the program goes on; the next one ends it.
class PoliteStop {
  public:
    PoliteStop(Signals& signals, std::function<void()> stop) : signals_(signals) {
        signals_.stop_with([this, stop = std::move(stop)] {
            asked_ = true;
            stop();
        });
    }
    ~PoliteStop() { signals_.stop_with({}); }
    PoliteStop(const PoliteStop&) = delete;
    PoliteStop& operator=(const PoliteStop&) = delete;

    /// Whether there was a signal.
    bool asked() const { return asked_; }

  private:
    Signals& signals_;
    std::atomic<bool> asked_ = false;
};

}  // namespace vvr::cli
