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

#include "core/media/av.h"
#include "core/media/decoder.h"
#include "core/media/demuxer.h"
#include "core/media/frame_source.h"

namespace vvr::media {

/// Converts a live stream's presentation timestamps to times that start at 0 and never decrease. Within a connection,
/// time follows the timestamps. Across a reconnection, or if a camera sets its clock, it follows the reader's clock.
class LiveClock {
  public:
    /// \param duration seconds per frame
    /// \param waits whether the sender waits for the reader, as a file does: then only the timestamps tell how long a
    ///     gap is
    /// \param by_arrival whether the stream has no timestamps, so that only the arrival tells the time
    explicit LiveClock(double duration, bool waits = false, bool by_arrival = false)
        : duration_(duration), waits_(waits), by_arrival_(by_arrival) {}

    /// Call it after a reconnection: later timestamps are unrelated to earlier ones.
    void restart() { stamp_.reset(); }

    /// The time of the next frame, in seconds.
    /// \param stamp seconds on the container's clock
    /// \param arrival when the frame arrived, seconds on a monotonic clock
    double operator()(std::optional<double> stamp, double arrival);

  private:
    double step(const std::optional<double>& stamp, double arrival) const;

    double duration_;
    bool waits_;
    bool by_arrival_;
    std::optional<double> time_;
    std::optional<double> stamp_;
    double delay_ = 0;  ///< between time and arrival, seconds
    double first_arrival_ = 0;
};

struct LiveOptions {
    SourceOptions source;
    double patience = 5;             ///< timeout in seconds after which a connection is lost
    double lag = 1;                  ///< seconds that a frame may wait; older ones are dropped
    std::optional<double> duration;  ///< seconds after which the stream ends
    std::function<void(const std::string&)> report = [](const std::string&) {
    };  ///< reports on connections; called from any thread
};

/// Reads the frames of a live stream: a URL, a camera device or a pipe. It reconnects with increasing pauses after a
/// connection is lost. Across such a gap, times follow the clock, so the gap keeps its length. Memory and delay are
/// bounded: late frames are dropped and counted. Frames of a pipe or a file, local or on a server, wait and are never
/// dropped.
///
/// In a gap of a second or more, the frame index skips the missing frames.
class LiveSource final : public FrameSource {
  public:
    using Clock = std::chrono::steady_clock;

    /// Waits for the first frame.
    /// \throws Error as `open_live_input`, Demuxer and Decoder; not_video if no frame decodes
    LiveSource(const std::string& name, LiveOptions options);
    ~LiveSource() override { stop(); }
    LiveSource(const LiveSource&) = delete;
    LiveSource& operator=(const LiveSource&) = delete;

    const VideoInfo& info() const override { return info_; }
    Size field_size() const override { return field_size_; }
    bool colour() const override { return options_.source.colour; }
    std::unique_ptr<DecodedFrame> next() override;
    std::int64_t damaged() const override;

    /// Does nothing: a live stream can't be read again.
    void rewind() override {}

    /// \throws Error usage, because a stream without an end can't be sampled
    std::vector<Frame> sample(int count) override;

    /// Ends the stream: `next` returns the frames that have arrived, and then null. Call it from any thread.
    void stop();

    std::int64_t dropped() const;
    std::int64_t reconnections() const;

    /// While the connection is lost, the time of the last frame, seconds.
    std::optional<double> lost_since() const;

    /// When a frame arrived. Known for the last few hundred frames.
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

    struct Early {
        AvFrame image;
        Clock::time_point when;
    };

    void connect();
    void learn_rate();
    void drop_oldest();
    void run(const std::stop_token& stop);
    bool reconnect(const std::stop_token& stop);
    bool add(AvFrame image, Clock::time_point now, const std::stop_token& stop);
    bool pause(const std::stop_token& stop, double seconds);
    bool is_over() const;
    void drop_late_frames();
    std::int64_t waiting_pixels() const;

    LiveOptions options_;
    std::shared_ptr<Watchdog> watchdog_;
    Input input_;
    bool reconnects_ = false;  ///< a lost connection can be made again
    bool waits_ = false;       ///< the sender waits for the reader
    std::unique_ptr<Demuxer> demuxer_;
    std::unique_ptr<Decoder> decoder_;
    std::deque<Early> first_;  ///< frames of this connection that were read before `run`
    VideoInfo info_;
    Size field_size_;
    Orientation orientation_;
    LiveClock clock_{0};
    Clock::time_point begin_ = Clock::now();
    double time_ = 0;  ///< of the newest frame, seconds
    std::int64_t index_ = -1;

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Waiting> waiting_;
    std::deque<Arrival> arrivals_;
    std::int64_t dropped_ = 0;
    std::int64_t reconnections_ = 0;
    std::int64_t damaged_ = 0;  ///< in all connections so far
    std::optional<double> lost_since_;
    bool ended_ = false;
    std::exception_ptr failure_;

    std::jthread reader_;  ///< last member, so it is joined first
};

}  // namespace vvr::media
