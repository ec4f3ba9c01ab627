#include "core/media/picture_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/media/av.h"
#include "core/media/decoder.h"
#include "core/media/demuxer.h"
#include "core/media/input.h"
#include "core/media/scaler.h"

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/pixfmt.h>
}

namespace vvr::media {

namespace {

struct Picture {
    AvFrame image;
    std::string codec;
};

/// \throws Error io, not_video, limit
Picture decode_picture(const std::string& path) {
    Demuxer demuxer(open_file(path), Demuxer::Kind::picture, 0);
    Decoder decoder(demuxer, path, 1);
    Picture picture{decoder.next(), avcodec_get_name(demuxer.stream().codecpar->codec_id)};
    if (!picture.image) throw Error(ErrorCode::no_frame, demuxer.log().text(AVERROR_INVALIDDATA));
    return picture;
}

/// Null for a picture that can't be read or decoded, which then counts as a damaged frame.
/// \throws Error out_of_memory
AvFrame try_decode_picture(const std::string& path) {
    try {
        return decode_picture(path).image;
    } catch (const Error& error) {
        if (error.code() == ErrorCode::out_of_memory) throw;
        return nullptr;
    }
}

/// Index of the first file at or after `time`, with a tolerance for rounded decimals.
std::size_t picture_at(double time, double rate, std::size_t files) {
    return static_cast<std::size_t>(std::clamp(std::ceil(time * rate - 1e-6), 0.0, static_cast<double>(files)));
}

std::vector<std::string> paths_of(const std::vector<SegmentPlace>& places) {
    std::vector<std::string> paths;
    for (const SegmentPlace& place : places) paths.push_back(place.path);
    return paths;
}

}  // namespace

PictureSource::PictureSource(const std::string& name, std::vector<std::string> files, const SourceOptions& options)
    : files_(std::move(files)), options_(options) {
    if (options_.rate == 0) options_.rate = assumed_rate;
    const double duration = static_cast<double>(files_.size()) / options_.rate;
    std::string why;
    for (const std::string& file : files_) {
        try {
            const auto first = decode_picture(file);
            info_ = {name,
                     "pictures",
                     first.codec,
                     {first.image->width, first.image->height},
                     options_.rate,
                     duration,
                     static_cast<std::int64_t>(files_.size())};
            break;
        } catch (const Error& error) {
            if (error.code() == ErrorCode::out_of_memory) throw;
            if (why.empty()) why = fmt::format("{}: {}", file, error.what());
        }
    }
    if (info_.frames == 0) {
        throw Error(
            ErrorCode::no_frame,
            fmt::format("cannot decode any of the {} pictures of '{}'; the first error: {}", files_.size(), name, why));
    }
    info_.read_at = options.rate;
    field_size_ = field_size_for(info_.size, options.field_size);
}

PictureSource::PictureSource(const std::string& name, const std::string& title, std::vector<SegmentPlace> places,
                             const SourceOptions& options)
    : PictureSource(name, paths_of(places), options) {
    places_ = std::move(places);
    info_.title = title;
    info_.began = options.begin;
    info_.began_source = ClockSource::file_name;
    info_.duration = places_.back().end;
    info_.frames = places_.back().first_frame + 1;
    info_.segments = places_;
}

std::unique_ptr<DecodedFrame> PictureSource::frame(std::size_t file, AvFrame image) const {
    if (!places_.empty()) {
        const SegmentPlace& place = places_[file];
        return std::make_unique<DecodedFrame>(DecodedFrame{place.first_frame, place.begin, {}, std::move(image)});
    }
    return std::make_unique<DecodedFrame>(
        DecodedFrame{static_cast<std::int64_t>(file), static_cast<double>(file) / options_.rate, {}, std::move(image)});
}

std::unique_ptr<DecodedFrame> PictureSource::next() {
    const auto cores = std::max(1u, std::thread::hardware_concurrency());
    const std::size_t threads = options_.threads > 0 ? static_cast<std::size_t>(std::min(options_.threads, 64)) : cores;
    while (next_ < files_.size()) {
        while (ahead_.size() < threads && next_ + ahead_.size() < files_.size()) {
            ahead_.push_back(
                std::async(std::launch::async, try_decode_picture, std::cref(files_[next_ + ahead_.size()])));
        }
        auto image = ahead_.front().get();
        ahead_.pop_front();
        const std::size_t file = next_++;
        if (image) return frame(file, std::move(image));
        ++damaged_;
    }
    return nullptr;
}

void PictureSource::rewind() {
    seek(0);
}

void PictureSource::seek(double seconds) {
    ahead_.clear();
    next_ = picture_at(seconds, options_.rate, files_.size());
    if (!places_.empty()) {
        const auto place = std::ranges::lower_bound(places_, seconds - time_tolerance, {}, &SegmentPlace::begin);
        next_ = static_cast<std::size_t>(place - places_.begin());
    }
    damaged_ = 0;
}

std::vector<Frame> PictureSource::sample(int count) {
    const std::size_t files = files_.size();
    const std::size_t wanted = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(1, count)), 1, files);
    Scaler scale(*this);
    std::vector<Frame> frames;
    for (std::size_t i = 0; i < wanted; ++i) {
        const std::size_t file = (2 * i + 1) * files / (2 * wanted);
        if (auto image = try_decode_picture(files_[file])) frames.push_back(scale(*frame(file, std::move(image))));
    }
    if (2 * frames.size() > wanted) {
        rewind();
        return frames;
    }
    return FrameSource::sample(count);
}

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
