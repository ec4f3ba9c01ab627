#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/media/decoder.h"
#include "core/media/frame_choice.h"
#include "core/media/hwaccel.h"
#include "core/media/input.h"

namespace vvr::media {

/// A larger step back of the timestamps means that the camera set its clock; seconds.
inline constexpr double clock_was_set = 1;

/// Converts a container's presentation timestamps to times that start at 0 and never decrease.
class StampClock {
  public:
    /// \param duration seconds per frame, used if a timestamp is missing
    explicit StampClock(double duration) : duration_(duration) {}

    /// \param origin timestamp of the clip's first frame, seconds
    StampClock(double duration, double origin) : duration_(duration), origin_(origin) {}

    /// The time of the next frame, in seconds. A small step back repeats the last time. A large one means that the
    /// camera set its clock, and time continues from the last frame.
    /// \param stamp seconds on the container's clock
    double operator()(std::optional<double> stamp);

    /// The first timestamp, seconds. Empty until a frame has one.
    std::optional<double> origin() const { return origin_; }

  private:
    double next() const;

    double duration_;
    std::optional<double> origin_;
    std::optional<double> last_;
};

/// Numbers frames by their times. Numbers are left out where frames are missing: where two frames are at least 5 s
/// apart, and 20 times as far as usual and as the two before. So low and varying frame rates are no holes.
class FrameNumbers {
  public:
    /// \param rate usual frames per second; 0 = unknown
    explicit FrameNumbers(double rate = 0) : rate_(rate) {}

    /// The number of the next frame; the first has 0.
    /// \param time seconds; must not decrease
    std::int64_t operator()(double time);

    /// The number of the last frame; -1 = none so far.
    std::int64_t last() const { return number_; }

  private:
    double rate_;
    std::int64_t number_ = -1;
    double last_ = 0;                 ///< seconds
    std::optional<double> interval_;  ///< of the two frames before, seconds
};

/// Where decoding must begin so that the first frame at or after a time is intact.
struct SeekPoint {
    std::int64_t packets = 0;  ///< packets to skip without decoding; 0 = decode from the first
    FrameNumbers numbers{};    ///< after the frames before the time; set only if `packets` isn't 0
};

/// Reads the frames of one container in order, with their times. It decodes with several threads up to the first damage
/// and with one thread after it, so a damaged clip gives the same frames in every run.
class VideoReader {
  public:
    struct Timed {
        AvFrame image;    ///< null at the end
        double time = 0;  ///< seconds from the clip's first frame
    };

    /// \throws Error as Demuxer and Decoder
    VideoReader(Input input, double rate, int threads, const FrameChoiceRow& choice = frame_choices().front(),
                const HwaccelRow& hwaccel = hwaccels().front());

    Timed next();

    /// Restarts at the first frame, and decodes other frames from now on.
    void choose(const FrameChoiceRow& choice);

    /// Restarts at the first frame, or at `start`. Call `next` at least once before.
    void rewind(const SeekPoint& start = {});

    /// Closes the file and frees its index, which is large for a long clip. `next` then returns nothing until a rewind.
    void close();

    /// Where decoding must begin for the first frame at or after `time`, in seconds.
    /// \param rate usual frames per second; 0 = unknown
    SeekPoint find(double time, double rate) const;

    /// Damaged packets or frames since the last rewind or call of `forget_damage`.
    std::int64_t damaged() const { return (decoder_ ? decoder_->damaged() : damaged_) - forgotten_; }
    void forget_damage() { forgotten_ = decoder_->damaged(); }

    /// Whether the processor has ever decoded frames that hardware was to decode.
    bool fell_back() const { return fell_back_ || (decoder_ && decoder_->fell_back()); }

    /// The frames whose timestamps were mended, of the longest read so far; seconds from the clip's first frame.
    MendedFrames mended() const;

    Demuxer& demuxer() const { return *demuxer_; }  ///< not after `close`
    const Input& input() const { return input_; }

    /// Presentation time of the first frame on the container's clock, seconds.
    double origin() const { return origin_.value_or(0); }

  private:
    void open(const SeekPoint& start);
    void fall_back_to_one_thread();

    Input input_;
    double rate_;
    int threads_;
    const FrameChoiceRow* choice_;
    const HwaccelRow* hwaccel_;
    std::unique_ptr<Demuxer> demuxer_;
    std::unique_ptr<FrameDecoder> decoder_;
    StampClock clock_{0};
    std::optional<double> origin_;
    std::int64_t damaged_ = 0;  ///< count of the closed decoder
    bool fell_back_ = false;    ///< whether a closed decoder has
    MendedFrames mended_;       ///< by closed demuxers

    SeekPoint start_;
    std::int64_t given_ = 0;  ///< frames returned since the last rewind
    double last_ = 0;         ///< time of the last returned frame, seconds
    std::int64_t forgotten_ = 0;

    std::int64_t pass_frames_ = 0;      ///< frames still to decode and discard
    std::optional<double> pass_until_;  ///< frames up to and including this time are discarded
};

}  // namespace vvr::media
