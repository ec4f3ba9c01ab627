#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/base/plane.h"
#include "core/kernels/colour_rows.h"

namespace vvr::video {

/// One decoded image at the field size, with its index in the clip and its presentation time.
struct Frame {
    std::int64_t index = 0;
    double pts = 0;            ///< seconds from the clip's first frame, from the container, never index / rate
    Plane<std::uint8_t> grey;  ///< luma
    Plane<Bgr> colour;         ///< same size as `grey`; empty unless asked for
};

/// A frame that several look at and nobody changes.
using SharedFrame = std::shared_ptr<const Frame>;

/// The frame as people see it: in colour where there is some, else in grey.
Plane<Bgr> picture_of(const Frame& frame);

}  // namespace vvr::video

struct AVFrame;

namespace vvr::video {

struct AvFrameFree {
    void operator()(AVFrame* frame) const;
};
using AvFrame = std::unique_ptr<AVFrame, AvFrameFree>;

/// How a stored picture becomes upright: rows and columns swapped first, then mirrored.
struct Orientation {
    bool transpose = false;
    bool flip_x = false;
    bool flip_y = false;

    friend bool operator==(const Orientation&, const Orientation&) = default;
};

/// A picture at the field size, not yet upright.
struct ScaledPicture {
    Plane<std::uint8_t> planes;  ///< luma in full range; in colour, below it Cb and Cr, of the same size
    std::optional<kernels::ColourMatrix> matrix{};  ///< only in colour

    int height() const { return matrix ? planes.height() / 3 : planes.height(); }
};

/// A frame of a source, cheap to move between threads; a `Scaler` makes a `Frame` of it. It has one of two pictures.
struct DecodedFrame {
    std::int64_t index = 0;
    double pts = 0;  ///< seconds from the clip's first frame
    Orientation orientation;
    AvFrame image;                          ///< as it left the decoder
    std::optional<ScaledPicture> scaled{};  ///< where the clip was kept after it was sampled
};

}  // namespace vvr::video
