#pragma once

#include <csignal>
#include <functional>
#include <mutex>
#include <thread>

namespace vvr {

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
    void wait(const std::stop_token& stop);

    sigset_t set_{};
    std::mutex writing_;
    std::mutex ending_;
    std::function<void()> last_words_;
    std::jthread waiter_;
};

}  // namespace vvr
