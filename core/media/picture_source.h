#pragma once

#include <cstdint>
#include <deque>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "core/media/frame_source.h"

namespace vvr::media {

/// Reads a sequence of picture files, one frame per file. Decodes ahead, one picture per thread.
class PictureSource final : public FrameSource {
  public:
    PictureSource(const std::string& name, std::vector<std::string> files, const SourceOptions& options);

    /// Pictures of known times, from `options.begin` on; `options.rate` is the usual one.
    PictureSource(const std::string& name, const std::string& title, std::vector<SegmentPlace> places,
                  const SourceOptions& options);

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
    std::vector<SegmentPlace> places_;  ///< of all files; empty = one after the other, at the rate
    SourceOptions options_;
    VideoInfo info_;
    Size field_size_;
    std::size_t next_ = 0;  ///< index of the file at the front of `ahead_`
    std::deque<std::future<AvFrame>> ahead_;
    std::int64_t damaged_ = 0;
};

}  // namespace vvr::media
