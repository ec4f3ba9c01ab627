#include "core/video/scaler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include "core/error.h"
#include "core/video/av.h"
#include "core/video/frame_source.h"

namespace vvr {
namespace {

cv::Size to_cv(Size size) {
    return {size.width, size.height};
}

/// Whether plane 0 is luma of 8 bits, and chroma, where there is any, lies in planes 1 and 2 or in pairs in plane 1.
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

/// Where nothing is said, large pictures are in HDTV's colours and small ones in television's, as players assume.
AVColorSpace colour_space(const AVFrame& frame) {
    if (frame.colorspace != AVCOL_SPC_UNSPECIFIED && frame.colorspace != AVCOL_SPC_RGB) return frame.colorspace;
    return frame.height > 576 ? AVCOL_SPC_BT709 : AVCOL_SPC_SMPTE170M;
}

/// Area averaging where the picture shrinks, linear where it grows; each way by itself.
cv::Mat resize(const cv::Mat& from, cv::Size to) {
    const cv::Size shrunk(std::min(from.cols, to.width), std::min(from.rows, to.height));
    cv::Mat smaller = from;
    if (shrunk != from.size()) cv::resize(from, smaller, shrunk, 0, 0, cv::INTER_AREA);
    if (shrunk == to) return smaller;
    cv::Mat larger;
    cv::resize(smaller, larger, to, 0, 0, cv::INTER_LINEAR);
    return larger;
}

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

constexpr std::uint8_t to_byte(int value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0, 255));
}

constexpr std::array<std::uint8_t, 256> full_range_table() {
    std::array<std::uint8_t, 256> table{};
    for (int i = 0; i < 256; ++i) table[static_cast<std::size_t>(i)] = to_byte((2 * (i - 16) * 255 + 219) / (2 * 219));
    return table;
}

/// Full-range luma and chroma to BGR, in 16-bit fixed point: the same on every machine.
class ColourMatrix {
  public:
    ColourMatrix(AVColorSpace space, bool full_range) {
        double red = 0.299;
        double blue = 0.114;
        if (space == AVCOL_SPC_BT709) std::tie(red, blue) = std::pair(0.2126, 0.0722);
        if (space == AVCOL_SPC_BT2020_NCL || space == AVCOL_SPC_BT2020_CL)
            std::tie(red, blue) = std::pair(0.2627, 0.0593);
        const double green = 1 - red - blue;
        const double stretch = full_range ? 1 : 255.0 / 224;
        red_of_cr_ = fixed(2 * (1 - red) * stretch);
        blue_of_cb_ = fixed(2 * (1 - blue) * stretch);
        green_of_cb_ = fixed(-2 * (1 - blue) * blue / green * stretch);
        green_of_cr_ = fixed(-2 * (1 - red) * red / green * stretch);
    }

    Bgr operator()(int luma, int cb, int cr) const {
        const int base = (luma << 16) + (1 << 15);
        cb -= 128;
        cr -= 128;
        return {to_byte((base + blue_of_cb_ * cb) >> 16), to_byte((base + green_of_cb_ * cb + green_of_cr_ * cr) >> 16),
                to_byte((base + red_of_cr_ * cr) >> 16)};
    }

  private:
    static int fixed(double value) { return static_cast<int>(std::lround(value * 65536)); }

    int red_of_cr_ = 0;
    int blue_of_cb_ = 0;
    int green_of_cb_ = 0;
    int green_of_cr_ = 0;
};

struct SwsFree {
    void operator()(SwsContext* context) const { sws_freeContext(context); }
};

}  // namespace

/// Brings any pixel format to 8-bit full-range luma, and chroma where colour is asked for, at the frame's own size.
class Scaler::Converter {
  public:
    const AVFrame& operator()(const AVFrame& from, bool colour) {
        const Key key{from.width, from.height, from.format, from.color_range, colour_space(from), colour};
        if (key_ != key) {
            key_.reset();
            prepare(from, colour);
            key_ = key;
        }
        sws_scale(context_.get(), from.data, from.linesize, 0, from.height, to_->data, to_->linesize);
        return *to_;
    }

  private:
    using Key = std::tuple<int, int, int, int, int, bool>;

    void prepare(const AVFrame& from, bool colour) {
        to_ = av::make_frame();
        to_->width = from.width;
        to_->height = from.height;
        to_->format = colour ? AV_PIX_FMT_YUV444P : AV_PIX_FMT_GRAY8;
        to_->color_range = AVCOL_RANGE_JPEG;
        to_->colorspace = colour_space(from);
        if (av_frame_get_buffer(to_.get(), 0) < 0)
            throw Error(ErrorKind::limit, fmt::format("out of memory for a picture of {}x{}", from.width, from.height));
        context_.reset(sws_getContext(from.width, from.height, static_cast<AVPixelFormat>(from.format), to_->width,
                                      to_->height, static_cast<AVPixelFormat>(to_->format),
                                      SWS_POINT | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_BITEXACT, nullptr,
                                      nullptr, nullptr));
        if (!context_) {
            const char* name = av_get_pix_fmt_name(static_cast<AVPixelFormat>(from.format));
            throw Error(ErrorKind::not_video,
                        fmt::format("pictures of pixel format {} and size {}x{} can't be converted; "
                                    "convert the video to yuv420p first",
                                    name ? name : "unknown", from.width, from.height));
        }
        const int* coefficients = sws_getCoefficients(to_->colorspace);
        const bool full = is_full_range(from) ||
                          av_pix_fmt_desc_get(static_cast<AVPixelFormat>(from.format))->flags & AV_PIX_FMT_FLAG_RGB;
        sws_setColorspaceDetails(context_.get(), coefficients, full, coefficients, 1, 0, 1 << 16, 1 << 16);
    }

    std::optional<Key> key_;
    std::unique_ptr<SwsContext, SwsFree> context_;
    AvFrame to_;
};

Scaler::Scaler(Size field_size, bool colour)
    : size_(field_size), colour_(colour), converter_(std::make_unique<Converter>()) {}
Scaler::Scaler(const FrameSource& source) : Scaler(source.field_size(), source.colour()) {}
Scaler::~Scaler() = default;
Scaler::Scaler(Scaler&&) noexcept = default;
Scaler& Scaler::operator=(Scaler&&) noexcept = default;

Frame Scaler::operator()(const DecodedFrame& decoded) {
    const AVFrame& from = *decoded.image;
    const bool direct = has_luma_plane(static_cast<AVPixelFormat>(from.format));
    const AVFrame& image = direct ? from : (*converter_)(from, colour_);
    const bool full_range = is_full_range(image);
    const Size stored = decoded.orientation.transpose ? Size{size_.height, size_.width} : size_;
    const auto fit = [&](int plane, Size size, int type) {
        return upright(resize(plane_of(image, plane, size, type), to_cv(stored)), decoded.orientation);
    };

    Frame frame{decoded.index, decoded.pts, Plane<std::uint8_t>(size_), {}};
    cv::Mat grey(to_cv(size_), CV_8UC1, frame.grey.pixels().data());
    const cv::Mat luma = fit(0, {image.width, image.height}, CV_8UC1);
    if (full_range) {
        luma.copyTo(grey);
    } else {
        static constexpr auto table = full_range_table();
        cv::LUT(luma, table, grey);
    }
    if (!colour_) return frame;

    frame.colour = Plane<Bgr>(size_);
    const auto& layout = *av_pix_fmt_desc_get(static_cast<AVPixelFormat>(image.format));
    if (layout.nb_components < 3) {
        std::transform(frame.grey.pixels().begin(), frame.grey.pixels().end(), frame.colour.pixels().begin(),
                       [](std::uint8_t value) {
                           return Bgr{value, value, value};
                       });
        return frame;
    }
    const Size chroma{AV_CEIL_RSHIFT(image.width, layout.log2_chroma_w),
                      AV_CEIL_RSHIFT(image.height, layout.log2_chroma_h)};
    std::array<cv::Mat, 2> cbcr;
    if (layout.comp[2].plane == 2) {
        cbcr = {fit(1, chroma, CV_8UC1), fit(2, chroma, CV_8UC1)};
    } else {
        cv::split(fit(1, chroma, CV_8UC2), cbcr.data());
        if (layout.comp[1].offset > layout.comp[2].offset) std::swap(cbcr[0], cbcr[1]);
    }
    const ColourMatrix to_bgr(colour_space(image), full_range);
    for (int j = 0; j < size_.height; ++j) {
        const auto* cb = cbcr[0].ptr<std::uint8_t>(j);
        const auto* cr = cbcr[1].ptr<std::uint8_t>(j);
        const auto y = frame.grey.row(j);
        const auto out = frame.colour.row(j);
        for (std::size_t i = 0; i < y.size(); ++i) out[i] = to_bgr(y[i], cb[i], cr[i]);
    }
    return frame;
}

}  // namespace vvr
