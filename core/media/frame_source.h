#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/wall_clock.h"
#include "core/media/frame.h"
#include "core/media/frame_choice.h"
#include "core/media/hwaccel.h"

namespace vvr::media {

/// A file of a recording, and its place in the recording.
struct SegmentPlace {
    std::string path;  ///< as found by `find_recording`
    double begin = 0;  ///< seconds of the recording
    double end = 0;
    std::int64_t first_frame = 0;  ///< index in the recording

    friend bool operator==(const SegmentPlace&, const SegmentPlace&) = default;
};

/// Files of a recording that are omitted, because other files cover the same times.
struct OmittedFrames {
    std::int64_t files = 0;
    std::int64_t frames = 0;
    double seconds = 0;
    std::vector<std::string> first{};  ///< the first of the files
};

/// Properties of a video from its container and first frame. Headers are unreliable, so counts are estimates.
struct VideoInfo {
    std::string name;                     ///< as the user gave it
    std::string container;                ///< short name of the format, e.g. "avi"; "pictures" for an image sequence
    std::string codec;                    ///< short name of the codec, e.g. "h264"
    Size size;                            ///< display size: after rotation, with square pixels
    double rate = 0;                      ///< frames per second, the container's average; 0 = unknown
    double duration = 0;                  ///< seconds; 0 = unknown
    std::int64_t frames = 0;              ///< estimate of the number of frames; 0 = unknown
    std::optional<std::int64_t> began{};  ///< when its first frame was recorded, seconds since 1970 (UTC)
    ClockSource began_source = ClockSource::none;  ///< source of `began`
    std::optional<std::int64_t> created{};         ///< the container's creation_time, seconds since 1970 (UTC)
    std::optional<std::int64_t> modified{};        ///< modification time minus duration, seconds since 1970 (UTC)
    std::string title{};                           ///< of an extraction: its clip's title; empty = use `name`
    std::vector<SegmentPlace> segments{};          ///< of a recording: its files read so far
    OmittedFrames left_out{};                      ///< of a recording: its omitted files
    std::int64_t unread = 0;                       ///< of a recording: files that could not be opened so far
    /// The frames that are decoded. `rate`, `frames` and every frame's index count only these.
    Choice<FrameChoiceRow> decodes{frame_choices().front()};
    double decoded_share = 1;                        ///< of all frames
    Choice<HwaccelRow> hwaccel{hwaccels().front()};  ///< what decoded the first frame
    double read_at = 0;  ///< frames per second in place of those that the files state; 0 = as they state
    double stretch = 1;  ///< seconds per second of the files' own clocks; other than 1 if `read_at` is given
};

/// Whether the time at which the clip was recorded is known, not only that of a copy.
inline bool recording_time_is_known(const VideoInfo& info) {
    return info.began && is_recording_time(info.began_source);
}

/// The shape of a picture.
struct Aspect {
    int width = 0;
    int height = 0;

    friend bool operator==(const Aspect&, const Aspect&) = default;
};

struct SourceOptions {
    Size field_size{0, 0};           ///< {0, 0}: long side at most 384, aspect kept; {-1, -1}: the video's own size
    bool colour = false;             ///< also fill Frame::colour
    int threads = 0;                 ///< decoder threads; 0 = one per core, or a single one for small pictures
    double rate = 0;                 ///< frames per second; 0 = as the input states, or else `assumed_rate`
    int track = 0;                   ///< as Input::track
    std::optional<Aspect> aspect{};  ///< of the picture as it is shown; none = as the input states
    Choice<FrameChoiceRow> decode{frame_choices().front()};  ///< frames of files; other inputs have all
    Choice<HwaccelRow> hwaccel{hwaccels().front()};  ///< what decodes files and streams; pictures: the processor
    std::int64_t layers = 0;              ///< for `auto`: of the volume; 0 = unknown, and all frames are decoded
    bool join = false;                    ///< as in `find_recording`
    std::optional<std::int64_t> begin{};  ///< recording time from the file name, seconds since 1970 (UTC)
};

/// Reads the frames of a video file, an image sequence or a stream, each once and in order.
class FrameSource {
  public:
    FrameSource() = default;
    virtual ~FrameSource() = default;
    FrameSource(const FrameSource&) = delete;
    FrameSource& operator=(const FrameSource&) = delete;

    virtual const VideoInfo& info() const = 0;

    /// The size that every `Frame` of this source has.
    virtual Size field_size() const = 0;

    /// Whether the frames of this source have colour.
    virtual bool colour() const = 0;

    /// The next frame that decodes, or null after the last one. Damaged packets are counted and skipped.
    virtual std::unique_ptr<DecodedFrame> next() = 0;

    /// Packets, or pictures of a sequence, since the first frame that were damaged or could not be decoded.
    virtual std::int64_t damaged() const = 0;

    /// Problems with input files since the first frame, one sentence each.
    virtual std::vector<std::string> problems() const { return {}; }

    /// When the times of frames were guessed since the first frame, in order; seconds of the clip.
    virtual std::vector<condition::Interval> doubtful_times() const { return {}; }

    /// Restarts at the first frame.
    virtual void rewind() = 0;

    /// Continues at the first frame at or after `seconds` if that is faster than reading from the first frame and the
    /// frame's index is known. Otherwise restarts at the first frame.
    virtual void seek(double seconds);

    /// Reads the frames at some times again, as far as that works: of a file by seeking, of a recording in the files
    /// that have them. Another read needs a `rewind`. \param times of frames that were read, ascending
    virtual void read_again(std::span<const double> times,
                            const std::function<void(std::shared_ptr<DecodedFrame>)>& sink);

    /// Chooses the size of the fields by the first file that has frames at or after `seconds`. Before the first frame.
    virtual void fit_size(double /*seconds*/) {}

    /// Samples at most `count` frames, spread in time over all frames that decode. Returns all frames if there are at
    /// most `count`, and otherwise more than count / 3. Restarts at the first frame. Holds at most `count` frames in
    /// memory. `Frame::index` is not set.
    virtual std::vector<Frame> sample(int count);

  protected:
    /// As `sample` by decoding every frame, but stays at the end.
    std::vector<Frame> sample_all(int count);
};

}  // namespace vvr::media
