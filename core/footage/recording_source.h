#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/footage/recording.h"
#include "core/media/file_source.h"
#include "core/media/frame_source.h"
#include "core/media/video_reader.h"

namespace vvr::footage {

/// Reads the files of a recording as one clip. One file is open at a time. `sample` and the estimate of the length also
/// read the headers or single frames of a few files.
///
/// A file that begins within a second of the previous file's end follows it. If it begins later, there is a gap, and
/// the frame index skips the missing frames. If it begins earlier, the frames that overlap are omitted. All frames are
/// scaled to the field size of the first file, or of the one that `fit_size` finds. A file that can't be read becomes a
/// problem and leaves a gap. A hole within a file is a gap too (`FrameNumbers`).
class RecordingSource final : public media::FrameSource {
  public:
    /// \throws Error not_video if no file can be read
    RecordingSource(Recording recording, const media::SourceOptions& options);

    const media::VideoInfo& info() const override { return info_; }
    Size field_size() const override { return field_size_; }
    bool colour() const override { return options_.colour; }
    std::unique_ptr<media::DecodedFrame> next() override;
    std::int64_t damaged() const override;
    std::vector<std::string> problems() const override;
    std::vector<condition::Interval> doubtful_times() const override { return doubtful_times_; }
    void rewind() override;
    std::vector<media::Frame> sample(int count) override;
    void read_again(std::span<const double> times,
                    const std::function<void(std::shared_ptr<media::DecodedFrame>)>& sink) override;
    void fit_size(double seconds) override;

  private:
    bool open_next();
    void close();
    [[noreturn]] void throw_gone() const;
    void count_overlap();
    void estimate_length();
    std::vector<media::Frame> sample_segments(int count) const;
    std::vector<media::Frame> sample_key_frames(int count);

    Recording recording_;
    media::SourceOptions options_;
    media::VideoInfo info_;
    Size field_size_;
    std::optional<std::int64_t> origin_;  ///< start of the recording, seconds since 1970 (UTC)
    ClockSource origin_source_ = ClockSource::none;

    std::size_t next_segment_ = 0;
    std::unique_ptr<media::FileSource> segment_;  ///< the segment that is being read
    SegmentBegin begin_;                          ///< start of that segment
    bool first_of_segment_ = true;
    double frame_ = 0;        ///< frame duration in the segment, also of frames that are not decoded, seconds
    double segment_end_ = 0;  ///< end of the last frame read, seconds of the segment
    double last_ = 0;         ///< time of the last returned frame, seconds
    double covered_ = 0;      ///< time of the last frame so far, decoded or not, seconds
    std::int64_t index_ = -1;
    media::FrameNumbers numbers_;   ///< by the times alone, across all segments
    std::int64_t unread_ = 0;       ///< packets that `sample` could not read
    std::int64_t damaged_ = 0;      ///< in the finished segments
    std::int64_t left_out_ = 0;     ///< frames of this segment that overlap the previous one
    media::OmittedFrames trimmed_;  ///< small overlaps between consecutive files
    std::vector<std::string> problems_;
    std::vector<condition::Interval> doubtful_times_;
};

/// A warning that names the first files: "2 files were omitted, ...".
/// \pre left_out.files > 0
std::string text_of(const media::OmittedFrames& left_out);

}  // namespace vvr::footage
