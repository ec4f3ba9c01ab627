#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/video/clock.h"
#include "core/video/decoder.h"
#include "core/video/demuxer.h"
#include "core/video/input.h"
#include "core/video/packet_scan.h"

namespace vvr::video {

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
    bool threaded() const { return threaded_; }

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
    bool threaded_ = false;     ///< the decoder
    std::int64_t damaged_ = 0;  ///< when it was closed

    SeekPoint start_;
    std::int64_t given_ = 0;  ///< frames since the last rewind
    double last_ = 0;         ///< time of the last of them
    std::int64_t forgotten_ = 0;

    std::int64_t pass_frames_ = 0;      ///< frames to decode and not to give
    std::optional<double> pass_until_;  ///< decode and skip frames up to this time, itself included
};

}  // namespace vvr::video
