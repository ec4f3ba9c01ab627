#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/video/file_source.h"
#include "core/video/frame_source.h"
#include "core/video/recording.h"

namespace vvr::video {

/// The frames of a recording of several files as those of one clip. One file is open at a time, and read once; what is
/// looked at before that to learn the empty scene are the headers of a few files, or one frame of each of a few.
///
/// Where a file begins within a second of the end of the one before, it follows it. Where it begins later, there is a
/// gap, and numbers skip the frames that it would have held. Where it begins earlier, what the one before has shown
/// already is left out. Frames of another size are brought to the field size of the first file's. A file that can't be
/// read is named among the problems, and leaves a gap.
class RecordingSource final : public FrameSource {
  public:
    /// \throws Error not_video when no file can be read
    RecordingSource(Recording recording, const SourceOptions& options);

    const VideoInfo& info() const override { return info_; }
    Size field_size() const override { return field_size_; }
    bool colour() const override { return options_.colour; }
    std::unique_ptr<DecodedFrame> next() override;
    std::int64_t damaged() const override;
    std::vector<std::string> problems() const override;
    void rewind() override;
    std::vector<Frame> sample(int count) override;

  private:
    bool open_next();
    void close();
    [[noreturn]] void throw_gone() const;
    void count_overlap();
    void estimate_length();
    std::vector<Frame> sample_segments(int count) const;
    std::vector<Frame> sample_key_frames(int count) const;

    Recording recording_;
    SourceOptions options_;
    VideoInfo info_;
    Size field_size_;
    std::optional<std::int64_t> origin_;  ///< of the recording's clock, seconds since 1970 (UTC)
    ClockSource origin_source_ = ClockSource::none;

    std::size_t next_segment_ = 0;
    std::unique_ptr<FileSource> segment_;  ///< that is being read
    SegmentBegin begin_;                   ///< of that segment
    bool first_of_segment_ = true;
    double frame_ = 0;        ///< seconds that a frame of the segment lasts
    double segment_end_ = 0;  ///< end of the last frame that was read, in seconds of the segment
    double last_ = 0;         ///< time of the last frame that was given
    std::int64_t index_ = -1;
    std::int64_t damaged_ = 0;   ///< in segments that have been read
    std::int64_t left_out_ = 0;  ///< frames of this segment at times that the one before has shown
    OmittedFrames trimmed_;      ///< files that begin a little before the one before has ended
    std::vector<std::string> problems_;
};

}  // namespace vvr::video
