#include "core/video/pixel_format.h"

#include <cstdint>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include "core/base/error.h"

namespace vvr::video {
namespace {

bool is_grey(AVPixelFormat format) {
    return av_pix_fmt_desc_get(format)->nb_components <= 2;
}

}  // namespace

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

AVColorSpace colour_space(const AVFrame& frame) {
    if (frame.colorspace != AVCOL_SPC_UNSPECIFIED && frame.colorspace != AVCOL_SPC_RGB) return frame.colorspace;
    return frame.height > 576 ? AVCOL_SPC_BT709 : AVCOL_SPC_SMPTE170M;
}

const AVFrame& PixelConverter::operator()(const AVFrame& from, bool colour) {
    const Key key{from.width, from.height, from.format, from.color_range, colour_space(from), colour};
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
    to_->colorspace = colour_space(from);
    if (av_frame_get_buffer(to_.get(), 0) < 0) {
        throw Error(ErrorKind::limit, fmt::format("out of memory for a picture of {}x{}", from.width, from.height));
    }
    const auto format = static_cast<AVPixelFormat>(from.format);
    const bool full = is_full_range(from) || av_pix_fmt_desc_get(format)->flags & AV_PIX_FMT_FLAG_RGB;
    context_.reset(sws_alloc_context());
    if (!context_) throw Error(ErrorKind::limit, "out of memory for converting a picture");
    // The ranges have to be known from the start: swscale chooses its short cuts by them.
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
        throw Error(ErrorKind::not_video, fmt::format("pictures of pixel format {} and size {}x{} can't be converted; "
                                                      "convert the video to yuv420p first",
                                                      name ? name : "unknown", from.width, from.height));
    }
    const int* coefficients = sws_getCoefficients(to_->colorspace);
    sws_setColorspaceDetails(context_.get(), coefficients, full, coefficients, 1, 0, 1 << 16, 1 << 16);
}

}  // namespace vvr::video
