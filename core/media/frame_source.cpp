#include "core/media/frame_source.h"

#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/plane.h"
#include "core/media/av.h"
#include "core/media/frame_sampler.h"
#include "core/media/scaler.h"

namespace vvr::media {

std::vector<Frame> FrameSource::sample(int count) {
    std::vector<Frame> frames = sample_all(count);
    rewind();
    return frames;
}

std::vector<Frame> FrameSource::sample_all(int count) {
    rewind();
    Scaler scale(*this);
    TimeSampler<Frame> sampler(count);
    FootageTime footage(info().rate);
    while (const auto decoded = next()) {
        const double time = footage(decoded->pts);
        if (sampler.wants(time)) sampler.keep(time, scale(*decoded));
    }
    return sampler.take();
}

Size field_size_for(Size shown, Size asked) {
    constexpr int default_long_side = 384;
    constexpr Size automatic{0, 0};
    constexpr Size source{-1, -1};
    Size size = asked == source ? shown : asked;
    if (asked == automatic) size = fit_into(shown, default_long_side);
    if (size.width < 1 || size.height < 1) {
        throw Error(ErrorCode::option_value_out_of_range,
                    fmt::format("a field of {}x{} pixels is too small; both sides must be at least 1", size.width,
                                size.height));
    }
    if (std::int64_t{size.width} * size.height > av::max_pixels) {
        throw Error(
            ErrorCode::picture_too_large,
            fmt::format("a field of {}x{} pixels is more than the limit of {} megapixels; choose smaller fields",
                        size.width, size.height, av::max_pixels / 1'000'000),
            {"field-size"});
    }
    return size;
}

void FrameSource::seek(double) {
    rewind();
}

void FrameSource::read_again(std::span<const double> times,
                             const std::function<void(std::shared_ptr<DecodedFrame>)>& sink) {
    constexpr double close = 60;  // seconds: where seeking leads farther back, reading goes on instead
    constexpr double same = 0.0005;
    std::shared_ptr<DecodedFrame> frame;
    bool seeks = true;
    for (const double time : times) {
        if (seeks) {
            seek(time);
            frame = next();
            seeks = frame && frame->pts >= time - close;
        }
        while (frame && frame->pts < time - same) frame = next();
        if (frame && frame->pts <= time + same) sink(frame);
    }
}

}  // namespace vvr::media
