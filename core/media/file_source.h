#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/media/frame_source.h"
#include "core/media/input.h"
#include "core/media/video_reader.h"

namespace vvr::media {

/// The frames of one container: a file, a spooled stream or a URL. In a hole of the timestamps, the frame index skips
/// the missing frames (`FrameNumbers`).
class FileSource final : public FrameSource {
  public:
    FileSource(Input input, const SourceOptions& options);

    const VideoInfo& info() const override { return info_; }
    Size field_size() const override { return field_size_; }
    bool colour() const override { return options_.colour; }
    std::unique_ptr<DecodedFrame> next() override;
    std::int64_t damaged() const override { return reader_.damaged(); }
    std::vector<std::string> problems() const override;
    std::vector<condition::Interval> doubtful_times() const override { return reader_.mended().intervals; }
    void rewind() override;
    void seek(double seconds) override;
    std::vector<Frame> sample(int count) override;

    /// One unit of the container's time base, seconds.
    double tick() const { return tick_; }

    /// Time of the file's last frame, decoded or not, seconds; 0 if all frames are decoded.
    double last_in_file() const { return last_in_file_; }

  private:
    void doubt_times(const Demuxer& demuxer);
    std::unique_ptr<DecodedFrame> record_jump(std::unique_ptr<DecodedFrame> frame);

    SourceOptions options_;
    VideoReader reader_;
    VideoInfo info_;
    Size field_size_;
    Orientation orientation_;
    double tick_ = 0;                 ///< one unit of the container's time base, seconds
    double from_ = 0;                 ///< seconds; earlier frames are skipped
    double implausible_length_ = 0;   ///< duration in the header if no clip is that long, seconds
    bool is_hdr_ = false;             ///< PQ or HLG
    double last_time_ = 0;            ///< time of the last returned frame, seconds
    double last_in_file_ = 0;         ///< time of the last frame, decoded or not, seconds
    double jump_ = 0;                 ///< longest implausible jump between two timestamps, seconds
    std::vector<std::string> notes_;  ///< what vvr takes for true, one sentence each
    SeekPoint start_;
    std::int64_t unread_ = 0;  ///< packets that `sample` could not read

    FrameNumbers numbers_;                 ///< those of the frames so far
    std::unique_ptr<DecodedFrame> ahead_;  ///< decoded by the constructor, not yet returned
};

}  // namespace vvr::media
