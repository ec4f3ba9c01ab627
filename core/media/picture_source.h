#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
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

/// The order of the channels of a pixel in memory; 8 bits per channel.
enum class PixelOrder { grey, rgb, bgr, rgba, bgra };

/// A frame in somebody else's memory.
struct MemoryFrame {
    const std::uint8_t* pixels = nullptr;  ///< the top row
    std::ptrdiff_t stride = 0;  ///< bytes from a row to the next one below; negative for rows from the bottom
    double seconds = 0;         ///< greater than that of the frame before
};

/// Frames that a caller passes one by one.
struct MemoryFrames {
    std::string name;  ///< for messages
    Size size;         ///< of each frame
    PixelOrder order = PixelOrder::bgr;
    double rate = 0;          ///< frames per second; 0 = unknown
    std::int64_t frames = 0;  ///< 0 = unknown
    /// Reads frame `index`. The indices are consecutive; each pass begins again with 0. The frame's memory must not
    /// change until the next call.
    /// \returns false after the last frame
    std::function<bool(std::int64_t index, MemoryFrame& frame)> read;
};

/// Reads frames from memory. It copies one frame at a time.
class MemorySource final : public FrameSource {
  public:
    /// \throws Error usage if the frames can't be read as described, not_video if there is none
    MemorySource(MemoryFrames frames, const SourceOptions& options);

    const VideoInfo& info() const override { return info_; }
    Size field_size() const override { return field_size_; }
    bool colour() const override { return options_.colour; }
    std::unique_ptr<DecodedFrame> next() override;
    std::int64_t damaged() const override { return 0; }
    void rewind() override { index_ = 0; }

  private:
    MemoryFrames frames_;
    SourceOptions options_;
    VideoInfo info_;
    Size field_size_;
    std::int64_t index_ = 0;  ///< of the next frame
    double begin_ = 0;        ///< time of the first frame, seconds
    double last_ = 0;         ///< time of the last returned frame, seconds
};

}  // namespace vvr::media
