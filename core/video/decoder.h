#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "core/video/demuxer.h"
#include "core/video/frame_choice.h"
#include "core/video/hwaccel.h"
#include "core/video/input.h"

namespace vvr::video {

/// Decodes the packets of one demuxer, in order. The demuxer must outlive the decoder.
class Decoder {
  public:
    /// For an intact stream, the frames don't depend on the number of threads. For a damaged stream, libav's
    /// multithreaded output depends on a race, so a decoder with several threads stops at the first damage.
    ///
    /// \param threads 0 = one per core, or a single one for small pictures
    /// \param decodes the packets that are decoded; empty = all
    /// \param hwaccel what decodes; if it can't decode this video, the processor does
    /// \throws Error not_video if FFmpeg has no decoder for the stream, hwaccel_unavailable
    Decoder(Demuxer& demuxer, const std::string& name, int threads, std::function<bool(const AVPacket&)> decodes = {},
            const HwaccelRow& hwaccel = hwaccels().front());

    /// The next frame that decodes. Null at the end, after too many consecutive failures, and once stopped.
    AvFrame next();

    /// The next frame that decodes on its own. Null at the end.
    AvFrame next_alone();

    /// Whether a decoder with several threads has stopped at damage.
    bool stopped() const { return stopped_; }

    /// Decodes one key packet on its own. Null if it is damaged or needs other packets. Don't mix with calls of `next`.
    /// \throws Error out_of_memory
    AvFrame decode_alone(const AVPacket& packet);

    /// Packets that could not be read or decoded, or that gave a damaged frame.
    std::int64_t damaged() const;

    /// Whether the processor has decoded frames that hardware was to decode.
    bool fell_back() const { return fell_back_; }

  private:
    bool read();
    AvFrame to_memory(AvFrame frame);

    Demuxer* demuxer_;
    std::function<bool(const AVPacket&)> decodes_;
    av::Ptr<AVCodecContext> codec_;
    av::Ptr<AVPacket> packet_ = av::make_packet();
    std::int64_t bad_packets_ = 0;
    std::int64_t bad_frames_ = 0;
    std::int64_t errors_at_start_ = 0;  ///< errors in the log when the decoder was opened
    bool wants_hardware_ = false;
    bool fell_back_ = false;
    bool threaded_ = false;
    bool stopped_ = false;
};

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

/// Where decoding must begin so that the first frame at or after a time is intact.
struct SeekPoint {
    std::int64_t packets = 0;  ///< packets to skip without decoding; 0 = decode from the first
    std::int64_t frames = 0;   ///< frames before the time; set only if `packets` isn't 0
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
    SeekPoint find(double time) const;

    /// Damaged packets or frames since the last rewind or call of `forget_damage`.
    std::int64_t damaged() const { return (decoder_ ? decoder_->damaged() : damaged_) - forgotten_; }
    void forget_damage() { forgotten_ = decoder_->damaged(); }

    /// Whether the processor has ever decoded frames that hardware was to decode.
    bool fell_back() const { return fell_back_ || (decoder_ && decoder_->fell_back()); }

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
    std::unique_ptr<Decoder> decoder_;
    StampClock clock_{0};
    std::optional<double> origin_;
    std::int64_t damaged_ = 0;  ///< count of the closed decoder
    bool fell_back_ = false;    ///< whether a closed decoder has

    SeekPoint start_;
    std::int64_t given_ = 0;  ///< frames returned since the last rewind
    double last_ = 0;         ///< time of the last returned frame, seconds
    std::int64_t forgotten_ = 0;

    std::int64_t pass_frames_ = 0;      ///< frames still to decode and discard
    std::optional<double> pass_until_;  ///< frames up to and including this time are discarded
};

}  // namespace vvr::video
