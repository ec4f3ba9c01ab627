#include "core/video/scaler.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <opencv2/core.hpp>

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/pixdesc.h>
}

#include "core/video/area_scaler.h"
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

}  // namespace

struct Scaler::Parts {
    PixelConverter convert;
    std::array<AreaScaler, 3> resize;  // one for each plane, so that none throws its tables away
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
    const bool full_range = is_full_range(image);
    const Size stored = decoded.orientation.transpose ? Size{size_.height, size_.width} : size_;
    const auto fit = [&](int plane, Size size, int type) {
        auto& resize = parts_->resize[static_cast<std::size_t>(plane)];
        return upright(resize(plane_of(image, plane, size, type), to_cv(stored)), decoded.orientation);
    };

    Frame frame{decoded.index, decoded.pts, Plane<std::uint8_t>::for_overwrite(size_), {}};
    cv::Mat grey(to_cv(size_), CV_8UC1, frame.grey.pixels().data());
    const cv::Mat luma = fit(0, {image.width, image.height}, CV_8UC1);
    if (full_range) {
        luma.copyTo(grey);
    } else {
        for (int j = 0; j < size_.height; ++j) {
            to_full_range({luma.ptr<std::uint8_t>(j), static_cast<std::size_t>(size_.width)}, frame.grey.row(j));
        }
    }
    if (!colour_) return frame;

    frame.colour = Plane<Bgr>::for_overwrite(size_);
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
    const ColourMatrix matrix(colour_space(image), full_range);
    const auto width = static_cast<std::size_t>(size_.width);
    for (int j = 0; j < size_.height; ++j) {
        to_bgr(matrix, frame.grey.row(j), {cbcr[0].ptr<std::uint8_t>(j), width}, {cbcr[1].ptr<std::uint8_t>(j), width},
               frame.colour.row(j));
    }
    return frame;
}

}  // namespace vvr
