#include "core/media/scaler.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/base/error.h"
#include "core/kernels/rows.h"
#include "core/media/av.h"
#include "core/media/frame_source.h"

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

namespace vvr::media {

namespace {

/// Scales 8-bit planes. Each axis is scaled separately: by area averaging to shrink, by linear interpolation to grow.
/// The result is valid until the next call.
class AreaScaler {
  public:
    /// \param from one or two channels; rows need libav's padding
    cv::Mat operator()(const cv::Mat& from, cv::Size to);

  private:
    cv::Mat shrink(const cv::Mat& from, cv::Size to);
    void prepare(cv::Size from, cv::Size to);

    std::optional<std::pair<cv::Size, cv::Size>> sizes_;
    AvPtr<SwsContext> context_;
    AvFrame scaled_;
};

cv::Mat AreaScaler::operator()(const cv::Mat& from, cv::Size to) {
    const cv::Size shrunk(std::min(from.cols, to.width), std::min(from.rows, to.height));
    cv::Mat smaller = shrunk == from.size() ? from : shrink(from, shrunk);
    if (shrunk == to) return smaller;
    cv::Mat larger(to, smaller.type());
    const bool is_double = to == cv::Size(2 * smaller.cols, 2 * smaller.rows) && smaller.channels() == 1;
    cv::resize(smaller, larger, to, 0, 0, is_double ? cv::INTER_LINEAR_EXACT : cv::INTER_LINEAR);
    return larger;
}

/// Both libraries average areas, and differ by at most one grey level. OpenCV is seven times faster at a ratio of 1/2.
/// swscale is two to ten times faster at other ratios, but its filters have a maximum length.
cv::Mat AreaScaler::shrink(const cv::Mat& from, cv::Size to) {
    constexpr int longest_filter = 64;
    const bool is_half = from.cols == 2 * to.width && from.rows == 2 * to.height;
    const bool is_long = from.cols > longest_filter * to.width || from.rows > longest_filter * to.height;
    if (is_half || is_long || from.channels() != 1) {
        cv::Mat smaller;
        cv::resize(from, smaller, to, 0, 0, cv::INTER_AREA);
        return smaller;
    }
    if (sizes_ != std::pair(from.size(), to)) prepare(from.size(), to);
    const std::array<const std::uint8_t*, 4> rows{from.data};
    const std::array<int, 4> strides{static_cast<int>(from.step[0])};
    sws_scale(context_.get(), rows.data(), strides.data(), 0, from.rows, scaled_->data, scaled_->linesize);
    return {to.height, to.width, CV_8UC1, scaled_->data[0], static_cast<std::size_t>(scaled_->linesize[0])};
}

void AreaScaler::prepare(cv::Size from, cv::Size to) {
    sizes_.reset();
    // swscale may write to the row padding, which libav allocates.
    scaled_ = av::make_frame();
    scaled_->width = to.width;
    scaled_->height = to.height;
    scaled_->format = AV_PIX_FMT_GRAY8;
    context_.reset(sws_getContext(from.width, from.height, AV_PIX_FMT_GRAY8, to.width, to.height, AV_PIX_FMT_GRAY8,
                                  SWS_AREA | SWS_ACCURATE_RND | SWS_BITEXACT, nullptr, nullptr, nullptr));
    if (!context_ || av_frame_get_buffer(scaled_.get(), 0) < 0) {
        throw Error(ErrorCode::out_of_memory, "out of memory for scaling a picture; choose smaller fields",
                    {"field-size"});
    }
    sizes_ = std::pair(from, to);
}

// ---- Pixel formats, and conversion of those without an 8-bit luma plane

/// Whether plane 0 is 8-bit luma, and chroma, if any, is in planes 1 and 2 or interleaved in plane 1.
bool has_luma_plane(AVPixelFormat format) {
    const auto* layout = av_pix_fmt_desc_get(format);
    constexpr std::uint64_t others = AV_PIX_FMT_FLAG_RGB | AV_PIX_FMT_FLAG_PAL | AV_PIX_FMT_FLAG_BITSTREAM |
                                     AV_PIX_FMT_FLAG_HWACCEL | AV_PIX_FMT_FLAG_BAYER;
    if (!layout || layout->flags & others || layout->nb_components == 2) return false;
    const auto& luma = layout->comp[0];
    if (luma.plane != 0 || luma.step != 1 || luma.offset != 0 || luma.shift != 0 || luma.depth != 8) return false;
    if (layout->nb_components == 1) return true;
    const auto& first = layout->comp[1];
    const auto& second = layout->comp[2];
    const bool planar = first.plane == 1 && second.plane == 2 && first.step == 1 && second.step == 1;
    const bool pairs = first.plane == 1 && second.plane == 1 && first.step == 2 && second.step == 2;
    return (planar || pairs) && first.depth == 8;
}

bool is_grey(AVPixelFormat format) {
    return av_pix_fmt_desc_get(format)->nb_components <= 2;
}

bool is_full_range(const AVFrame& frame) {
    switch (frame.format) {
        case AV_PIX_FMT_YUVJ420P:
        case AV_PIX_FMT_YUVJ422P:
        case AV_PIX_FMT_YUVJ444P:
        case AV_PIX_FMT_YUVJ440P:
        case AV_PIX_FMT_YUVJ411P:
            return true;
        default:
            break;
    }
    const auto format = static_cast<AVPixelFormat>(frame.format);
    if (is_grey(format)) return frame.color_range != AVCOL_RANGE_MPEG;
    return frame.color_range == AVCOL_RANGE_JPEG;
}

/// Converts any pixel format to 8-bit full-range luma, with chroma on request, at the frame's size.
class PixelConverter {
  public:
    /// The result is valid until the next call.
    ///
    /// \throws Error not_video if the pixel format can't be converted, limit if out of memory
    const AVFrame& operator()(const AVFrame& from, bool colour);

  private:
    using Key = std::tuple<int, int, int, int, int, bool>;

    void prepare(const AVFrame& from, bool colour);

    std::optional<Key> key_;
    AvPtr<SwsContext> context_;
    AvFrame to_;
};

const AVFrame& PixelConverter::operator()(const AVFrame& from, bool colour) {
    const Key key{from.width, from.height, from.format, from.color_range, av::colour_space_of(from), colour};
    if (key_ != key) {
        key_.reset();
        prepare(from, colour);
        key_ = key;
    }
    sws_scale(context_.get(), from.data, from.linesize, 0, from.height, to_->data, to_->linesize);
    return *to_;
}

void PixelConverter::prepare(const AVFrame& from, bool colour) {
    to_ = av::make_frame();
    to_->width = from.width;
    to_->height = from.height;
    to_->format = colour ? AV_PIX_FMT_YUV444P : AV_PIX_FMT_GRAY8;
    to_->color_range = AVCOL_RANGE_JPEG;
    to_->colorspace = av::colour_space_of(from);
    if (av_frame_get_buffer(to_.get(), 0) < 0) {
        throw Error(
            ErrorCode::out_of_memory,
            fmt::format("out of memory for a picture of {}x{}; scale the video down first", from.width, from.height));
    }
    const auto format = static_cast<AVPixelFormat>(from.format);
    const bool full = is_full_range(from) || av_pix_fmt_desc_get(format)->flags & AV_PIX_FMT_FLAG_RGB;
    context_.reset(sws_alloc_context());
    if (!context_)
        throw Error(ErrorCode::out_of_memory, "out of memory for converting a picture; give vvr more memory");
    // The ranges must be set before the initialisation, where swscale chooses its special cases.
    const std::initializer_list<std::pair<const char*, int>> options{
        {"srcw", from.width},
        {"srch", from.height},
        {"src_format", from.format},
        {"src_range", full},
        {"dstw", to_->width},
        {"dsth", to_->height},
        {"dst_format", to_->format},
        {"dst_range", 1},
        {"sws_flags", SWS_POINT | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_BITEXACT},
    };
    for (const auto& [name, value] : options) av_opt_set_int(context_.get(), name, value, 0);
    if (sws_init_context(context_.get(), nullptr, nullptr) < 0) {
        const char* name = av_get_pix_fmt_name(format);
        throw Error(ErrorCode::not_video, fmt::format("cannot convert pictures of pixel format {} and size {}x{}; "
                                                      "convert the video to yuv420p first",
                                                      name ? name : "unknown", from.width, from.height));
    }
    const int* coefficients = sws_getCoefficients(to_->colorspace);
    sws_setColorspaceDetails(context_.get(), coefficients, full, coefficients, 1, 0, 1 << 16, 1 << 16);
}

// ---- Pictures at the field size

cv::Mat plane_of(const AVFrame& frame, int plane, Size size, int type) {
    return {size.height, size.width, type, frame.data[plane], static_cast<std::size_t>(frame.linesize[plane])};
}

/// `from` mirrored and turned as `orientation` says.
cv::Mat upright(cv::Mat from, Orientation orientation) {
    if (orientation.transpose) from = from.t();
    if (!orientation.flip_x && !orientation.flip_y) return from;
    cv::Mat flipped;
    cv::flip(from, flipped, orientation.flip_x ? (orientation.flip_y ? -1 : 1) : 0);
    return flipped;
}

}  // namespace

struct Scaler::Parts {
    PixelConverter convert;
    std::array<AreaScaler, 3> resize;  // one per plane, so that each keeps its tables
};

Scaler::Scaler(Size field_size, bool colour) : size_(field_size), colour_(colour), parts_(std::make_unique<Parts>()) {}
Scaler::Scaler(const FrameSource& source) : Scaler(source.field_size(), source.colour()) {}
Scaler::~Scaler() = default;
Scaler::Scaler(Scaler&&) noexcept = default;
Scaler& Scaler::operator=(Scaler&&) noexcept = default;

Frame Scaler::operator()(const DecodedFrame& decoded) {
    const AVFrame& from = *decoded.image;
    const bool direct = has_luma_plane(static_cast<AVPixelFormat>(from.format));
    const AVFrame& image = direct ? from : parts_->convert(from, colour_);
    const Orientation orientation = decoded.orientation;
    const cv::Size stored =
        orientation.transpose ? cv::Size(size_.height, size_.width) : cv::Size(size_.width, size_.height);
    const auto fit = [&](int plane, Size size, int type) {
        return parts_->resize[static_cast<std::size_t>(plane)](plane_of(image, plane, size, type), stored);
    };
    const auto width = static_cast<std::size_t>(size_.width);
    const auto row = [width](const cv::Mat& plane, int j) { return std::span(plane.ptr<std::uint8_t>(j), width); };

    Frame frame{decoded.index, decoded.pts, Plane<std::uint8_t>::for_overwrite(size_), {}};
    frame.before = decoded.before;
    const cv::Mat luma = upright(fit(0, {image.width, image.height}, CV_8UC1), orientation);
    if (is_full_range(image)) {
        luma.copyTo(cv_view(frame.grey));
    } else {
        for (int j = 0; j < size_.height; ++j) kernels::to_full_range(row(luma, j), frame.grey.row(j));
    }
    if (!colour_) return frame;

    frame.colour = Plane<Bgr>::for_overwrite(size_);
    const auto& layout = *av_pix_fmt_desc_get(static_cast<AVPixelFormat>(image.format));
    if (layout.nb_components < 3) {
        cv::cvtColor(cv_view(frame.grey), cv_view(frame.colour), cv::COLOR_GRAY2BGR);
        return frame;
    }
    const Size size{AV_CEIL_RSHIFT(image.width, layout.log2_chroma_w),
                    AV_CEIL_RSHIFT(image.height, layout.log2_chroma_h)};
    std::array<cv::Mat, 2> chroma;  // Cb and Cr
    if (layout.comp[2].plane == 2) {
        chroma = {fit(1, size, CV_8UC1), fit(2, size, CV_8UC1)};
    } else {
        cv::split(fit(1, size, CV_8UC2), chroma.data());
        if (layout.comp[1].offset > layout.comp[2].offset) std::swap(chroma[0], chroma[1]);
    }
    for (cv::Mat& plane : chroma) plane = upright(plane, orientation);
    const kernels::ColourMatrix matrix(av::colour_space_of(image), is_full_range(image));
    for (int j = 0; j < size_.height; ++j) {
        kernels::to_bgr(matrix, frame.grey.row(j), row(chroma[0], j), row(chroma[1], j), frame.colour.row(j));
    }
    return frame;
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

}  // namespace vvr::media
