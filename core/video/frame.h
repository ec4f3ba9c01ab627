#pragma once

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
Plane<Bgr> picture_of(const Frame& frame);

}  // namespace vvr::video
