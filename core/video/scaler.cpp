#include "core/video/scaler.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <opencv2/core.hpp>

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/pixdesc.h>
}

#include "core/error.h"
#include "core/video/area_scaler.h"
#include "core/video/av.h"
#include "core/video/colour_rows.h"
#include "core/video/frame_source.h"
#include "core/video/pixel_format.h"

namespace vvr {
namespace {

cv::Size to_cv(Size size) {
    return {size.width, size.height};
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

/// A picture's planes, valid until the next one is scaled. Chroma is empty where it isn't asked for or there is none.
struct ScaledPlanes {
    cv::Mat luma;
    std::array<cv::Mat, 2> chroma;  ///< blue, red; of luma's size
    bool full_range;
    AVColorSpace space;
};

AvFrame to_frame(const ScaledPlanes& planes) {
    AvFrame frame = av::make_frame();
    frame->width = planes.luma.cols;
    frame->height = planes.luma.rows;
    frame->format = planes.chroma[0].empty() ? AV_PIX_FMT_GRAY8 : AV_PIX_FMT_YUV444P;
    frame->color_range = planes.full_range ? AVCOL_RANGE_JPEG : AVCOL_RANGE_MPEG;
    frame->colorspace = planes.space;
    if (av_frame_get_buffer(frame.get(), 0) < 0) throw Error(ErrorKind::limit, "out of memory for a scaled picture");
    const Size size{frame->width, frame->height};
    cv::Mat luma = plane_of(*frame, 0, size, CV_8UC1);
    planes.luma.copyTo(luma);
    for (std::size_t i = 0; i < 2 && !planes.chroma[i].empty(); ++i) {
        cv::Mat chroma = plane_of(*frame, static_cast<int>(i) + 1, size, CV_8UC1);
        planes.chroma[i].copyTo(chroma);
    }
    return frame;
}

}  // namespace

struct Scaler::Parts {
    PixelConverter convert;
    std::array<AreaScaler, 3> resize;  // one for each plane, so that none throws its tables away

    ScaledPlanes scale(const DecodedFrame& decoded, Size upright_size, bool colour);
};

ScaledPlanes Scaler::Parts::scale(const DecodedFrame& decoded, Size upright_size, bool colour) {
    const AVFrame& from = *decoded.image;
    const bool direct = has_luma_plane(static_cast<AVPixelFormat>(from.format));
    const AVFrame& image = direct ? from : convert(from, colour);
    const Size stored = decoded.orientation.transpose ? Size{upright_size.height, upright_size.width} : upright_size;
    const auto fit = [&](int plane, Size size, int type) {
        return resize[static_cast<std::size_t>(plane)](plane_of(image, plane, size, type), to_cv(stored));
    };

    ScaledPlanes planes{fit(0, {image.width, image.height}, CV_8UC1), {}, is_full_range(image), colour_space(image)};
    const auto& layout = *av_pix_fmt_desc_get(static_cast<AVPixelFormat>(image.format));
    if (!colour || layout.nb_components < 3) return planes;
    const Size chroma{AV_CEIL_RSHIFT(image.width, layout.log2_chroma_w),
                      AV_CEIL_RSHIFT(image.height, layout.log2_chroma_h)};
    if (layout.comp[2].plane == 2) {
        planes.chroma = {fit(1, chroma, CV_8UC1), fit(2, chroma, CV_8UC1)};
    } else {
        cv::split(fit(1, chroma, CV_8UC2), planes.chroma.data());
        if (layout.comp[1].offset > layout.comp[2].offset) std::swap(planes.chroma[0], planes.chroma[1]);
    }
    return planes;
}

Scaler::Scaler(Size field_size, bool colour) : size_(field_size), colour_(colour), parts_(std::make_unique<Parts>()) {}
Scaler::Scaler(const FrameSource& source) : Scaler(source.field_size(), source.colour()) {}
Scaler::~Scaler() = default;
Scaler::Scaler(Scaler&&) noexcept = default;
Scaler& Scaler::operator=(Scaler&&) noexcept = default;

DecodedFrame Scaler::shrink(const DecodedFrame& decoded) {
    return {decoded.index, decoded.pts, decoded.orientation, to_frame(parts_->scale(decoded, size_, colour_))};
}

Frame Scaler::operator()(const DecodedFrame& decoded) {
    const ScaledPlanes planes = parts_->scale(decoded, size_, colour_);
    Frame frame{decoded.index, decoded.pts, Plane<std::uint8_t>::for_overwrite(size_), {}};
    cv::Mat grey(to_cv(size_), CV_8UC1, frame.grey.pixels().data());
    const cv::Mat luma = upright(planes.luma, decoded.orientation);
    const auto width = static_cast<std::size_t>(size_.width);
    if (planes.full_range) {
        luma.copyTo(grey);
    } else {
        for (int j = 0; j < size_.height; ++j) to_full_range({luma.ptr<std::uint8_t>(j), width}, frame.grey.row(j));
    }
    if (!colour_) return frame;

    frame.colour = Plane<Bgr>::for_overwrite(size_);
    if (planes.chroma[0].empty()) {
        std::transform(frame.grey.pixels().begin(), frame.grey.pixels().end(), frame.colour.pixels().begin(),
                       [](std::uint8_t value) {
                           return Bgr{value, value, value};
                       });
        return frame;
    }
    const cv::Mat blue = upright(planes.chroma[0], decoded.orientation);
    const cv::Mat red = upright(planes.chroma[1], decoded.orientation);
    const ColourMatrix matrix(planes.space, planes.full_range);
    for (int j = 0; j < size_.height; ++j) {
        to_bgr(matrix, frame.grey.row(j), {blue.ptr<std::uint8_t>(j), width}, {red.ptr<std::uint8_t>(j), width},
               frame.colour.row(j));
    }
    return frame;
}

}  // namespace vvr
