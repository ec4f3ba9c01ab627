#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>

#include "core/base/plane.h"

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
inline Plane<Bgr> picture_of(const Frame& frame) {
    if (!frame.colour.empty()) return frame.colour;
    Plane<Bgr> picture(frame.grey.size());
    std::ranges::transform(frame.grey.pixels(), picture.pixels().begin(), [](std::uint8_t grey) {
        return Bgr{grey, grey, grey};
    });
    return picture;
}

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

/// A frame of a source, cheap to move between threads; a `Scaler` makes a `Frame` of it.
struct DecodedFrame {
    std::int64_t index = 0;
    double pts = 0;  ///< seconds from the clip's first frame
    Orientation orientation;
    AvFrame image;  ///< as it left the decoder
};

}  // namespace vvr::video
