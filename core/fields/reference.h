#pragma once

#include <cstdint>
#include <span>

#include "core/plane.h"
#include "core/video/frame.h"

namespace vvr {

/// The empty scene that the difference filter compares with (§4, Fig. 4a).
struct Reference {
    Plane<std::uint8_t> grey;
    Plane<Bgr> colour;  ///< empty for frames without colour

    bool empty() const { return grey.empty(); }
};

/// The median of every pixel over `frames`, channel by channel: what was seen in more than half of them. With an
/// even number of frames it is the upper of the two middle values. Frames must be of one size; none gives an
/// empty reference.
Reference median_reference(std::span<const Frame> frames);

}  // namespace vvr
