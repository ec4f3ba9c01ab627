#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/video/av.h"
#include "core/video/decoder.h"
#include "core/video/demuxer.h"
#include "core/video/frame_source.h"
#include "core/video/frame_times.h"

namespace vvr::video {

struct LiveOptions {
    SourceOptions source;
    double patience = 5;             ///< seconds without a frame after which a connection counts as lost
    double lag = 1;                  ///< seconds that a frame may wait for its turn; older ones are dropped
    std::optional<double> duration;  ///< seconds after which the stream ends
    std::function<void(const std::string&)> tell = [](const std::string&) {};  ///< of connections, from any thread
};

/// The frames of a stream as they come: a URL, a camera's device, a pipe. A connection that breaks is made again, with
/// pauses that grow; the frames' times go on by the clock meanwhile, and their numbers with them, so that a gap has the
/// length that it had. Memory is bounded, and so is the delay: frames for which there is no time are dropped and
/// counted. Frames of a pipe or a file wait, of a file on a server too; none of
/// them is dropped.
///
/// Numbers skip the frames that a gap of a second and more would have held.
class LiveSource final : public FrameSource {
  public:
    using Clock = std::chrono::steady_clock;

    /// Waits for the first frame.
    /// \throws Error as `open_live_input`, Demuxer and Decoder do; not_video when no frame comes
    LiveSource(const std::string& name, LiveOptions options);
    ~LiveSource() override { stop(); }
    LiveSource(const LiveSource&) = delete;
    LiveSource& operator=(const LiveSource&) = delete;

    const VideoInfo& info() const override { return info_; }
    Size field_size() const override { return field_size_; }
    bool colour() const override { return options_.source.colour; }
    std::unique_ptr<DecodedFrame> next() override;
    std::int64_t damaged() const override;

    /// What has been is gone: goes on with the next frame.
    void rewind() override {}

    /// \throws Error usage, as there is no whole to take samples of
    std::vector<Frame> sample(int count) override;

    /// Ends the stream: `next` gives what has come already, and then nothing. From any thread, at any time.
    void stop();

    std::int64_t dropped() const;
    std::int64_t reconnections() const;

    /// When one of the last few hundred frames came.
    std::optional<Clock::time_point> arrival(std::int64_t index) const;

  private:
    struct Arrival {
        std::int64_t index = 0;
        Clock::time_point when;
    };
    struct Waiting {
        std::unique_ptr<DecodedFrame> frame;
        Clock::time_point since;
    };

    void connect();
    void run(const std::stop_token& stop);
    bool reconnect(const std::stop_token& stop);
    bool add(AvFrame image, const std::stop_token& stop);
    bool pause(const std::stop_token& stop, double seconds);
    bool is_over() const;
    void drop_late_frames();
    std::int64_t waiting_pixels() const;

    LiveOptions options_;
    std::shared_ptr<Watchdog> watchdog_;
    Input input_;
    bool reconnects_ = false;  ///< a connection that ends can be made again
    bool waits_ = false;       ///< the sender waits until we read
    std::unique_ptr<Demuxer> demuxer_;
    std::unique_ptr<Decoder> decoder_;
    AvFrame first_;
    VideoInfo info_;
    Size field_size_;
    Orientation orientation_;
    LiveClock clock_{0};
    Clock::time_point begin_ = Clock::now();
    double time_ = 0;  ///< of the newest frame
    std::int64_t index_ = -1;

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Waiting> waiting_;
    std::deque<Arrival> arrivals_;
    std::int64_t dropped_ = 0;
    std::int64_t reconnections_ = 0;
    std::int64_t damaged_ = 0;  ///< of the connections before, and of this one so far
    bool ended_ = false;
    std::exception_ptr failure_;

    std::jthread reader_;  ///< last, so that it ends first
};

}  // namespace vvr::video
