#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/video/demuxer.h"
#include "core/video/frame_times.h"
#include "core/video/input.h"

namespace vvr::video {

/// Decodes the packets of one demuxer, in order. Must not outlive it.
class Decoder {
  public:
    /// More than one thread decodes an intact stream to the same frames as one thread does. What libav makes of a
    /// damaged one depends on which thread was the faster, so such a decoder stops at the first damage instead.
    ///
    /// \param threads 0 = one for each core, or one alone for small pictures
    /// \throws Error not_video when there is no decoder for the stream
    Decoder(Demuxer& demuxer, const std::string& name, int threads);

    /// The next frame that decodes; nothing at the end, after very many failures in a row, or when it has stopped.
    AvFrame next();

    /// Whether it met damage that only a decoder of one thread may pass.
    bool stopped() const { return stopped_; }

    /// The frame of one key packet by itself; nothing when it doesn't decode alone. Not to be mixed with `next`.
    AvFrame decode_alone(const AVPacket& packet);

    /// Packets that failed to be read or decoded, or gave a damaged frame.
    std::int64_t damaged() const;

  private:
    Demuxer* demuxer_;
    av::Ptr<AVCodecContext> codec_;
    av::Ptr<AVPacket> packet_ = av::make_packet();
    std::int64_t bad_packets_ = 0;
    std::int64_t bad_frames_ = 0;
    std::int64_t errors_at_start_ = 0;  ///< in the log
    bool threaded_ = false;
    bool stopped_ = false;
};

/// Where decoding has to begin so that the first frame at or after a time comes out whole.
struct SeekPoint {
    std::int64_t packets = 0;  ///< packets to pass over undecoded; 0 = decode from the first
    std::int64_t frames = 0;   ///< frames before the time; only where `packets` isn't 0
};

/// The frames of one container in order, with their times. Decodes with several threads until the first damage, and
/// with one from there on, so that a damaged clip gives the same frames at every run.
class VideoReader {
  public:
    struct Timed {
        AvFrame image;    ///< none at the end
        double time = 0;  ///< seconds from the clip's first frame
    };

    /// \throws Error as Demuxer and Decoder do
    VideoReader(Input input, double rate, int threads);

    Timed next();

    /// Begins again: at the first frame, or where `start` says. The clip's first frame has to have been read once.
    void rewind(const SeekPoint& start = {});

    /// Gives back what reading takes, of a long clip above all its index. Until the next rewind there are no frames.
    void close();

    /// Where to begin for the first frame at or after `time`, in seconds.
    SeekPoint find(double time) const;

    /// Packets and frames that were damaged since the last rewind, or `forget_damage`.
    std::int64_t damaged() const { return (decoder_ ? decoder_->damaged() : damaged_) - forgotten_; }
    void forget_damage() { forgotten_ = decoder_->damaged(); }

    Demuxer& demuxer() const { return *demuxer_; }  ///< only while it isn't closed
    const Input& input() const { return input_; }

    /// The first frame's time on the container's own clock, seconds.
    double origin() const { return origin_.value_or(0); }

  private:
    void open(const SeekPoint& start);
    void fall_back_to_one_thread();

    Input input_;
    double rate_;
    int threads_;
    std::unique_ptr<Demuxer> demuxer_;
    std::unique_ptr<Decoder> decoder_;
    StampClock clock_{0};
    std::optional<double> origin_;
    std::int64_t damaged_ = 0;  ///< when it was closed

    SeekPoint start_;
    std::int64_t given_ = 0;  ///< frames since the last rewind
    double last_ = 0;         ///< time of the last of them
    std::int64_t forgotten_ = 0;

    std::int64_t pass_frames_ = 0;      ///< frames to decode and not to give
    std::optional<double> pass_until_;  ///< decode and skip frames up to this time, itself included
};

}  // namespace vvr::video
