#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/wall_clock.h"
#include "core/video/frame.h"

namespace vvr::video {

class RecorderNames;

/// A file of a recording, and when it was in it.
struct SegmentPlace {
    std::string path;  ///< as it was found
    double begin = 0;  ///< seconds of the recording
    double end = 0;
    std::int64_t first_frame = 0;  ///< index in the recording

    friend bool operator==(const SegmentPlace&, const SegmentPlace&) = default;
};

/// Files of a recording that show only what others show too, and so are not in it.
struct OmittedFrames {
    std::int64_t files = 0;
    std::int64_t frames = 0;
    double seconds = 0;
    std::vector<std::string> first{};  ///< some of the files
};

/// What of them is left out, with the names of the first: "2 files are left out whole, ..."; for one file or more.
std::string text_of(const OmittedFrames& left_out);

/// What a container says of its video, and its first frame. Headers lie: counts are estimates.
struct VideoInfo {
    std::string name;                     ///< as the user gave it
    std::string container;                ///< short name of the format, e.g. "avi"; "pictures" for an image sequence
    std::string codec;                    ///< short name of the codec, e.g. "h264"
    Size size;                            ///< of the picture as it is to be seen: rotated, square pixels
    double rate = 0;                      ///< frames per second, the container's average; 0 = unknown
    double duration = 0;                  ///< seconds; 0 = unknown
    std::int64_t frames = 0;              ///< estimate of the number of frames; 0 = unknown
    std::optional<std::int64_t> began{};  ///< when its first frame was recorded, seconds since 1970 (UTC)
    ClockSource began_source = ClockSource::none;  ///< what tells that
    std::optional<std::int64_t> created{};         ///< the container's creation_time, seconds since 1970 (UTC)
    std::optional<std::int64_t>
        modified{};       ///< when it began if the file was written last at its end, seconds since 1970 (UTC)
    std::string title{};  ///< of the clip that data files were extracted from; empty = see the name
    std::vector<SegmentPlace> segments{};  ///< of a recording of several files, those that were read so far
    OmittedFrames left_out{};              ///< of these files
};

/// Whether the time at which a clip began is that of its recording, not that of some copy of it.
inline bool recording_time_is_known(const VideoInfo& info) {
    return info.began && is_recording_time(info.began_source);
}

struct SourceOptions {
    Size field_size{0, 0};  ///< {0, 0}: long side at most 384, aspect kept; {-1, -1}: the video's own size
    bool colour = false;    ///< fill Frame::colour as well
    int threads = 0;        ///< decoder threads; 0 = one for each core, or one alone for small pictures
    double rate = 25;       ///< frames per second of what carries no times: image sequences, raw streams
    bool join = false;      ///< as `find_recording` has it
    std::optional<std::int64_t> begin{};  ///< when a file was recorded as its name tells, seconds since 1970 (UTC)
};

/// Frames of a video file, an image sequence or a piped stream, each once and in order.
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

    /// The next frame that decodes; nothing after the last one. Damaged packets are counted and skipped.
    virtual std::unique_ptr<DecodedFrame> next() = 0;

    /// Packets, or pictures of a sequence, that could not be decoded or came out damaged since the first frame.
    virtual std::int64_t damaged() const = 0;

    /// What was wrong with some of the files that it reads, since the first frame: a sentence each.
    virtual std::vector<std::string> problems() const { return {}; }

    /// Starts again at the first frame.
    virtual void rewind() = 0;

    /// Goes on with the first frame at or after `seconds`, if that is faster than reading from the first frame
    /// and the frame's number is known; else starts again at the first frame.
    virtual void seek(double seconds);

    /// At most `count` frames spread in time over the whole of what is really there;
    /// all of them where there are no more than `count`, else more than a third of it. Leaves the source at its
    /// first frame. Holds no more than `count` frames at a time. The frames' `index` is not filled in.
    virtual std::vector<Frame> sample(int count);
};

/// Opens a video: a file, a URL, `-` for a stream on stdin, or a sequence of pictures given as a folder, a glob
/// (`dir/*.png`) or a printf pattern (`dir/%05d.png`). Decodes the first frame, so a source that opens has one.
///
/// A pipe is spooled to an unlinked file in $TMPDIR, or /var/tmp, first: it is read more than once.
///
/// \throws Error io when it can't be read or spooled, not_video when it holds no frame that decodes, limit when its
///         pictures are too large, usage when `options` and the clip don't fit
std::unique_ptr<FrameSource> open_source(const std::string& name, const SourceOptions& options = {});

/// Opens what some names mean together: a recording of several files (see `find_recording`), or what one name means.
/// \param layouts that names of files have
/// \param warnings what is to be said of it, a sentence each
/// \throws Error as above, and as find_recording does
std::unique_ptr<FrameSource> open_sources(const std::vector<std::string>& names, const SourceOptions& options,
                                          const RecorderNames& layouts, std::vector<std::string>& warnings);

/// The files of this machine that are read where `name` is given as an input: a file, those that a folder, a pattern or
/// a list names, what stdin is (`-`), or the file that holds an address (`@FILE`). All that may be read counts, be it a
/// clip, a picture, or part of an extraction. What can't be looked at is left out: who opens it says why.
std::vector<std::filesystem::path> files_of_input(const std::string& name);

/// The field size that `asked` (as in SourceOptions) means for pictures of size `shown`.
///
/// \throws Error usage for a size that isn't positive, limit for one that is too large
Size field_size_for(Size shown, Size asked);

}  // namespace vvr::video
