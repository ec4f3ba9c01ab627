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

/// The files that `name` means if it names a sequence of pictures, in natural order: a folder, a glob
/// (`dir/*.png`) or a printf pattern (`dir/%05d.png`). Nothing if it is none of these, or if there is a file of that
/// name.
///
/// \throws Error io when the folder can't be read or no file matches, not_video for a folder without pictures,
///         usage for a pattern with more than one number or other conversions
std::optional<std::vector<std::string>> list_pictures(const std::string& name);

/// Frames that are a picture file each. Some are decoded ahead of time, one in each thread.
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
    std::size_t next_ = 0;  ///< the file that the front of `ahead_` decodes
    std::deque<std::future<AvFrame>> ahead_;
    std::int64_t damaged_ = 0;
};

}  // namespace vvr::video
