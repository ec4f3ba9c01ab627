#include "core/video/scaler.h"

#include <array>
#include <utility>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/pixdesc.h>
}

#include "core/base/cv_view.h"
#include "core/kernels/colour_rows.h"
#include "core/video/area_scaler.h"
#include "core/video/frame_source.h"
#include "core/video/pixel_format.h"

namespace vvr::video {
namespace {

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

/// \param scaled has `scaled`
Frame finished(const DecodedFrame& decoded, Size size, bool colour) {
    const ScaledPicture& scaled = *decoded.scaled;
    const auto part = [&](int number) {
        const int height = scaled.height();
        return upright(cv_view(scaled.planes).rowRange(number * height, (number + 1) * height), decoded.orientation);
    };
    Frame frame{decoded.index, decoded.pts, Plane<std::uint8_t>::for_overwrite(size), {}};
    part(0).copyTo(cv_view(frame.grey));
    if (!colour) return frame;

    frame.colour = Plane<Bgr>::for_overwrite(size);
    if (!scaled.matrix) {
        cv::cvtColor(cv_view(frame.grey), cv_view(frame.colour), cv::COLOR_GRAY2BGR);
        return frame;
    }
    const cv::Mat cb = part(1);
    const cv::Mat cr = part(2);
    const auto width = static_cast<std::size_t>(size.width);
    for (int j = 0; j < size.height; ++j) {
        kernels::to_bgr(*scaled.matrix, frame.grey.row(j), {cb.ptr<std::uint8_t>(j), width},
                        {cr.ptr<std::uint8_t>(j), width}, frame.colour.row(j));
    }
    return frame;
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

DecodedFrame Scaler::shrink(const DecodedFrame& decoded) {
    const AVFrame& from = *decoded.image;
    const bool direct = has_luma_plane(static_cast<AVPixelFormat>(from.format));
    const AVFrame& image = direct ? from : parts_->convert(from, colour_);
    const Size stored = decoded.orientation.transpose ? Size{size_.height, size_.width} : size_;
    const auto fit = [&](int plane, Size size, int type) {
        AreaScaler& resize = parts_->resize[static_cast<std::size_t>(plane)];
        return resize(plane_of(image, plane, size, type), {stored.width, stored.height});
    };
    const auto& layout = *av_pix_fmt_desc_get(static_cast<AVPixelFormat>(image.format));
    const bool coloured = colour_ && layout.nb_components >= 3;
    ScaledPicture scaled{Plane<std::uint8_t>::for_overwrite({stored.width, (coloured ? 3 : 1) * stored.height})};
    const auto part = [&](int number) {
        return cv_view(scaled.planes).rowRange(number * stored.height, (number + 1) * stored.height);
    };

    const cv::Mat luma = fit(0, {image.width, image.height}, CV_8UC1);
    if (is_full_range(image)) {
        luma.copyTo(part(0));
    } else {
        const auto width = static_cast<std::size_t>(stored.width);
        for (int j = 0; j < stored.height; ++j)
            kernels::to_full_range({luma.ptr<std::uint8_t>(j), width}, scaled.planes.row(j));
    }
    if (coloured) {
        scaled.matrix.emplace(colour_space(image), is_full_range(image));
        const Size chroma{AV_CEIL_RSHIFT(image.width, layout.log2_chroma_w),
                          AV_CEIL_RSHIFT(image.height, layout.log2_chroma_h)};
        if (layout.comp[2].plane == 2) {
            fit(1, chroma, CV_8UC1).copyTo(part(1));
            fit(2, chroma, CV_8UC1).copyTo(part(2));
        } else {
            std::array<cv::Mat, 2> to{part(1), part(2)};
            if (layout.comp[1].offset > layout.comp[2].offset) std::swap(to[0], to[1]);
            cv::split(fit(1, chroma, CV_8UC2), to.data());
        }
    }
    return {decoded.index, decoded.pts, decoded.orientation, nullptr, std::move(scaled)};
}

Frame Scaler::operator()(const DecodedFrame& decoded) {
    return decoded.scaled ? finished(decoded, size_, colour_) : finished(shrink(decoded), size_, colour_);
}

}  // namespace vvr::video
