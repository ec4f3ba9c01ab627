#pragma once

#include <cstdint>
#include <deque>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/video/frame_source.h"

namespace vvr::video {

/// The files of a picture sequence, in natural order. `name` is a folder, a glob (`dir/*.png`) or a printf pattern
/// (`dir/%05d.png`). Empty if it is none of these, or if a file has that name.
///
/// \throws Error io if the folder can't be read or no file matches, not_video for a folder without pictures, usage for
///         a pattern with several numbers or other conversions
std::optional<std::vector<std::string>> list_pictures(const std::string& name);

/// Reads a sequence of picture files, one frame per file. Decodes ahead, one picture per thread.
class PictureSource final : public FrameSource {
  public:
    PictureSource(const std::string& name, std::vector<std::string> files, const SourceOptions& options);

    const VideoInfo& info() const override { return info_; }
    Size field_size() const override { return field_size_; }
    bool colour() const override { return options_.colour; }
    std::unique_ptr<DecodedFrame> next() override;
    std::int64_t damaged() const override { return damaged_; }
    void rewind() override;
    void seek(double seconds) override;
    std::vector<Frame> sample(int count) override;

  private:
    std::unique_ptr<DecodedFrame> frame(std::size_t file, AvFrame image) const;

    std::vector<std::string> files_;
    SourceOptions options_;
    VideoInfo info_;
    Size field_size_;
    std::size_t next_ = 0;  ///< index of the file at the front of `ahead_`
    std::deque<std::future<AvFrame>> ahead_;
    std::int64_t damaged_ = 0;
};

}  // namespace vvr::video
