#pragma once

#include <atomic>
#include <chrono>

namespace vvr::video {

/// Ends reads of a live stream from outside: when somebody asks for it, or when nothing has come for too long. A reader
/// asks `expired`, from any thread.
class Watchdog {
  public:
    /// \param patience how long a read may take
    explicit Watchdog(std::chrono::duration<double> patience)
        : patience_(std::chrono::duration_cast<Clock::duration>(patience)) {}

    /// A read begins now.
    void feed() { fed_ = Clock::now(); }

    /// No read goes on, nor begins any more.
    void stop() { stopped_ = true; }

    bool stopped() const { return stopped_; }
    bool expired() const { return stopped_ || Clock::now() - fed_.load() > patience_; }

  private:
    using Clock = std::chrono::steady_clock;

    Clock::duration patience_;
    std::atomic<Clock::time_point> fed_ = Clock::now();
    std::atomic<bool> stopped_ = false;
};

}  // namespace vvr::video
