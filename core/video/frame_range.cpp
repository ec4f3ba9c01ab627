#include "core/video/frame_range.h"

#include <utility>

#include <fmt/format.h>

#include "core/error.h"

namespace vvr {

namespace {

class FrameRange final : public FrameSource {
  public:
    FrameRange(std::unique_ptr<FrameSource> source, std::int64_t first, std::optional<std::int64_t> end)
        : source_(std::move(source)), first_(first), end_(end) {
        ahead_ = next();
        if (!ahead_) {
            throw Error(ErrorKind::usage,
                        fmt::format("'{}' has no frame from {} to {}: it has {}; change --start or --end", info().name,
                                    first_, end_ ? fmt::to_string(*end_) : "its end", seen_));
        }
    }

    const VideoInfo& info() const override { return source_->info(); }
    Size field_size() const override { return source_->field_size(); }
    bool colour() const override { return source_->colour(); }
    std::int64_t damaged() const override { return source_->damaged(); }

    std::unique_ptr<DecodedFrame> next() override {
        if (ahead_) return std::move(ahead_);
        while (auto frame = source_->next()) {
            seen_ = frame->index + 1;
            if (end_ && frame->index >= *end_) return nullptr;
            if (frame->index >= first_) return frame;
        }
        return nullptr;
    }

    void rewind() override {
        ahead_.reset();
        source_->rewind();
    }

  private:
    std::unique_ptr<FrameSource> source_;
    std::int64_t first_;
    std::optional<std::int64_t> end_;
    std::int64_t seen_ = 0;
    std::unique_ptr<DecodedFrame> ahead_;
};

}  // namespace

std::unique_ptr<FrameSource> limit_frames(std::unique_ptr<FrameSource> source, std::int64_t first,
                                          std::optional<std::int64_t> end) {
    return std::make_unique<FrameRange>(std::move(source), first, end);
}

}  // namespace vvr
