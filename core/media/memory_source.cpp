#include "core/media/memory_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/media/scaler.h"

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/pixfmt.h>
}

#include "core/base/error.h"
#include "core/media/av.h"

namespace vvr::media {

namespace {

struct PixelOrderRow {
    PixelOrder order;
    std::string_view name;
    AVPixelFormat format;
    int bytes;  ///< per pixel
};

constexpr std::array pixel_orders{
    PixelOrderRow{PixelOrder::grey, "grey", AV_PIX_FMT_GRAY8, 1},
    PixelOrderRow{PixelOrder::rgb, "rgb", AV_PIX_FMT_RGB24, 3},
    PixelOrderRow{PixelOrder::bgr, "bgr", AV_PIX_FMT_BGR24, 3},
    PixelOrderRow{PixelOrder::rgba, "rgba", AV_PIX_FMT_RGBA, 4},
    PixelOrderRow{PixelOrder::bgra, "bgra", AV_PIX_FMT_BGRA, 4},
};

const PixelOrderRow& row_of(PixelOrder order) {
    return *std::ranges::find(pixel_orders, order, &PixelOrderRow::order);
}

AvFrame copy_of(const MemoryFrame& frame, Size size, const PixelOrderRow& row) {
    AvFrame image = av::make_frame();
    image->format = row.format;
    image->width = size.width;
    image->height = size.height;
    if (av_frame_get_buffer(image.get(), 0) < 0) {
        throw Error(ErrorCode::out_of_memory, "out of memory for a frame; pass smaller frames");
    }
    const auto bytes = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(row.bytes);
    for (int y = 0; y < size.height; ++y) {
        const std::uint8_t* const from = frame.pixels + y * frame.stride;
        std::copy_n(from, bytes, image->data[0] + y * std::ptrdiff_t{image->linesize[0]});
    }
    return image;
}

}  // namespace

MemorySource::MemorySource(MemoryFrames frames, const SourceOptions& options)
    : frames_(std::move(frames)), options_(options) {
    const Size size = frames_.size;
    const bool has_size = size.width > 0 && size.height > 0;
    if (!frames_.read || !has_size || !std::isfinite(frames_.rate) || frames_.rate < 0 || frames_.frames < 0) {
        throw Error(ErrorCode::input_unsuitable,
                    fmt::format("{}: {}x{} pixels, {} frames per second, {} frames{}; a width and a height of at least "
                                "1 and a function that reads are needed, and 0 or more for the others",
                                frames_.name, size.width, size.height, frames_.rate, frames_.frames,
                                frames_.read ? "" : ", nothing to read them with"));
    }
    if (std::int64_t{size.width} * size.height > av::max_pixels) {
        throw Error(ErrorCode::picture_too_large,
                    fmt::format("{}: {}x{} pixels are more than the limit of {} megapixels; pass smaller frames",
                                frames_.name, size.width, size.height, av::max_pixels / 1'000'000));
    }
    info_.name = frames_.name;
    info_.container = "memory";
    info_.codec = "rawvideo";
    info_.size = size;
    info_.rate = frames_.rate;
    info_.frames = frames_.frames;
    info_.duration = frames_.rate > 0 ? static_cast<double>(frames_.frames) / frames_.rate : 0;
    field_size_ = field_size_for(size, options.field_size);
    if (!next()) throw Error(ErrorCode::no_frame, fmt::format("{}: the source delivered no frames", frames_.name));
    rewind();
}

std::unique_ptr<DecodedFrame> MemorySource::next() {
    MemoryFrame frame;
    if (!frames_.read(index_, frame)) return nullptr;
    const PixelOrderRow& row = row_of(frames_.order);
    const std::ptrdiff_t least = std::ptrdiff_t{frames_.size.width} * row.bytes;
    const std::ptrdiff_t most = PTRDIFF_MAX / frames_.size.height;
    if (frame.pixels == nullptr || frame.stride < -most || frame.stride > most || std::abs(frame.stride) < least) {
        throw Error(ErrorCode::input_unsuitable,
                    fmt::format("{}, frame {}: {} and a stride of {} bytes; a row of {} {} pixels has {} bytes",
                                frames_.name, index_, frame.pixels == nullptr ? "no pixels" : "pixels", frame.stride,
                                frames_.size.width, row.name, least));
    }
    if (!std::isfinite(frame.seconds) || (index_ > 0 && frame.seconds <= last_)) {
        throw Error(ErrorCode::input_unsuitable,
                    fmt::format("{}, frame {}: it is at {} s, and the frame before at {} s; times must increase",
                                frames_.name, index_, frame.seconds, last_));
    }
    if (index_ == 0) begin_ = frame.seconds;
    last_ = frame.seconds;
    return std::make_unique<DecodedFrame>(
        DecodedFrame{index_++, frame.seconds - begin_, {}, copy_of(frame, frames_.size, row)});
}

}  // namespace vvr::media
