#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/video/clock.h"
#include "core/video/decoder.h"
#include "core/video/demuxer.h"
#include "core/video/frame_source.h"
#include "core/video/input.h"
#include "core/video/packet_scan.h"

namespace vvr {

/// The frames of one container: a file, a spooled stream or a URL.
class FileSource final : public FrameSource {
  public:
    FileSource(Input input, const SourceOptions& options);

    const VideoInfo& info() const override { return info_; }
    Size field_size() const override { return field_size_; }
    bool colour() const override { return options_.colour; }
    std::unique_ptr<DecodedFrame> next() override;
    std::int64_t damaged() const override { return decoder_->damaged(); }
    void rewind() override;
    std::vector<Frame> sample(int count) override;

  private:
    void open();
    void describe(const AVFrame& first);
    std::unique_ptr<DecodedFrame> decode();
    std::vector<Frame> sample_key_frames(int count) const;

    Input input_;
    SourceOptions options_;
    VideoInfo info_;
    Size field_size_;
    Orientation orientation_;
    double origin_ = 0;  ///< the first frame's time on the container's clock
    Start start_;

    std::unique_ptr<Demuxer> demuxer_;
    std::unique_ptr<Decoder> decoder_;
    Clock clock_{0};
    std::int64_t index_ = 0;
    std::unique_ptr<DecodedFrame> ahead_;  ///< decoded while opening, not yet given out
};

}  // namespace vvr
