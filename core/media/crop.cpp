
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <memory>
#include <span>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/base/error.h"
#include "core/media/av.h"
#include "core/media/scaler.h"

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/pixdesc.h>
}

namespace vvr::media {

namespace {

/// The frame's own pixels.
Plane<Bgr> small_crop_of(const Frame& frame, const PixelBox& box, int longest_side) {
    const cv::Rect place(box.left, box.top, box.width(), box.height());
    Plane<Bgr> part = Plane<Bgr>::for_overwrite(box.size());
    cv::Mat own = cv_view(part);
    if (frame.colour.empty()) {
        cv::cvtColor(cv_view(frame.grey)(place), own, cv::COLOR_GRAY2BGR);
    } else {
        cv_view(frame.colour)(place).copyTo(own);
    }
    const Size size = fit_into(box.size(), longest_side);
    if (size == box.size()) return part;
    Plane<Bgr> smaller = Plane<Bgr>::for_overwrite(size);
    cv::Mat out = cv_view(smaller);
    cv::resize(cv_view(part), out, out.size(), 0, 0, cv::INTER_AREA);
    return smaller;
}

/// A decoded picture, and how its stored pixels and the pixels of its upright picture belong together.
class UprightPicture {
  public:
    explicit UprightPicture(const DecodedFrame& decoded)
        : decoded_(decoded), stored_{decoded.image->width, decoded.image->height} {
        size_ = decoded.orientation.transpose ? Size{stored_.height, stored_.width} : stored_;
    }

    Size size() const { return size_; }

    /// The smallest part that contains `box` and can be cut out of the stored planes; empty if outside the picture.
    PixelBox part_around(const PixelBox& box) const {
        const AVPixFmtDescriptor* const format =
            av_pix_fmt_desc_get(static_cast<AVPixelFormat>(decoded_.image->format));
        constexpr std::uint64_t indivisible = AV_PIX_FMT_FLAG_BITSTREAM | AV_PIX_FMT_FLAG_HWACCEL;
        const PixelBox whole{0, 0, size_.width, size_.height};
        if (format == nullptr || (format->flags & indivisible) != 0) return whole;
        constexpr int grid = 16;  // a multiple of all distances of chroma samples
        const PixelBox stored = stored_box(intersection(box, whole));
        const PixelBox aligned{stored.left / grid * grid, stored.top / grid * grid,
                               (stored.right + grid - 1) / grid * grid, (stored.bottom + grid - 1) / grid * grid};
        if (stored.empty()) return {};
        return upright_box(intersection(aligned, {0, 0, stored_.width, stored_.height}));
    }

    /// A part in another size, upright.
    Plane<Bgr> converted(const PixelBox& part, Size to) const {
        const PixelBox stored = stored_box(part);
        AvFrame image(av_frame_clone(decoded_.image.get()));
        if (!image) throw Error(ErrorCode::out_of_memory, "out of memory for a part of a frame; use fewer threads");
        image->colorspace = av::colour_space_of(*image);  // that of unspecified ones depends on the size
        image->crop_left = static_cast<std::size_t>(stored.left);
        image->crop_top = static_cast<std::size_t>(stored.top);
        image->crop_right = static_cast<std::size_t>(stored_.width - stored.right);
        image->crop_bottom = static_cast<std::size_t>(stored_.height - stored.bottom);
        if (av_frame_apply_cropping(image.get(), AV_FRAME_CROP_UNALIGNED) < 0) {
            throw Error(ErrorCode::not_video, "cannot cut a part out of a frame of this pixel format");
        }
        return Scaler(to, true)({decoded_.index, decoded_.pts, decoded_.orientation, std::move(image)}).colour;
    }

  private:
    PixelBox flipped(PixelBox box) const {
        if (decoded_.orientation.flip_x) {
            box = {size_.width - box.right, box.top, size_.width - box.left, box.bottom};
        }
        if (decoded_.orientation.flip_y) {
            box = {box.left, size_.height - box.bottom, box.right, size_.height - box.top};
        }
        return box;
    }

    PixelBox transposed(const PixelBox& box) const {
        return decoded_.orientation.transpose ? PixelBox{box.top, box.left, box.bottom, box.right} : box;
    }

    PixelBox stored_box(const PixelBox& upright) const { return transposed(flipped(upright)); }
    PixelBox upright_box(const PixelBox& stored) const { return flipped(transposed(stored)); }

    const DecodedFrame& decoded_;
    Size stored_;
    Size size_;
};

int nearest(double value) {
    return static_cast<int>(std::lround(value));
}

/// Pixels of the upright picture per field pixel. They differ if the stored pixels aren't square.
struct Ratio {
    double x;
    double y;
};

Plane<Bgr> full_crop_of(const UprightPicture& picture, const Ratio& ratio, const FullSize& place, const PixelBox& box,
                        int longest_side) {
    const double most = std::max(ratio.x, ratio.y);  // the shorter side of a pixel is stretched, so no detail is lost
    const Size to = fit_into({nearest(box.width() * most), nearest(box.height() * most)}, longest_side);
    const Ratio shrunk{to.width / (box.width() * ratio.x), to.height / (box.height() * ratio.y)};
    const double left = (box.left + place.left) * ratio.x;
    const double top = (box.top + place.top) * ratio.y;
    // Chroma is interpolated between the pixels around.
    constexpr int margin = 4;
    const PixelBox wanted = PixelBox{static_cast<int>(std::floor(left)), static_cast<int>(std::floor(top)),
                                     static_cast<int>(std::ceil(left + box.width() * ratio.x)),
                                     static_cast<int>(std::ceil(top + box.height() * ratio.y))}
                                .inflated(margin, margin);
    const PixelBox part = picture.part_around(wanted);
    if (part.empty()) throw Error(ErrorCode::not_video, "a part of a frame is outside its picture");
    const Plane<Bgr> larger = picture.converted(
        part, {std::max(1, nearest(part.width() * shrunk.x)), std::max(1, nearest(part.height() * shrunk.y))});

    // Beyond the picture's edge, which a shaking camera moves, its last pixels are repeated.
    const int x = nearest((left - part.left) * shrunk.x);
    const int y = nearest((top - part.top) * shrunk.y);
    Plane<Bgr> crop = Plane<Bgr>::for_overwrite(to);
    for (int j = 0; j < to.height; ++j) {
        const std::span<const Bgr> from = larger.row(std::clamp(y + j, 0, larger.height() - 1));
        const std::span<Bgr> row = crop.row(j);
        for (int i = 0; i < to.width; ++i) {
            row[static_cast<std::size_t>(i)] = from[static_cast<std::size_t>(std::clamp(x + i, 0, larger.width() - 1))];
        }
    }
    return crop;
}

}  // namespace

Plane<Bgr> crop_of(const Frame& frame, const PixelBox& box, int longest_side) {
    const std::shared_ptr<const DecodedFrame> decoded = frame.full_size.picture.lock();
    if (!decoded) return small_crop_of(frame, box, longest_side);
    const UprightPicture picture(*decoded);
    const Ratio ratio{static_cast<double>(picture.size().width) / frame.grey.width(),
                      static_cast<double>(picture.size().height) / frame.grey.height()};
    if (std::max(ratio.x, ratio.y) <= 1) return small_crop_of(frame, box, longest_side);
    try {
        return full_crop_of(picture, ratio, frame.full_size, box, longest_side);
    } catch (const std::exception&) {
        return small_crop_of(frame, box, longest_side);  // the run is worth more than a sharp crop
    }
}

}  // namespace vvr::media
