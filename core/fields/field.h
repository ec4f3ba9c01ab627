#pragma once

#include <cstdint>
#include <vector>

#include "core/base/plane.h"
#include "core/fields/seed_flags.h"

namespace vvr::fields {

/// Optical flow of one frame in field pixels per frame, u to the right, v down (the convention of .flo files).
struct Flow {
    Plane<float> u;
    Plane<float> v;
};

/// A point of the flow field at which a glyph or a traceline starts (§4.2).
struct Seed {
    float x = 0;  ///< column in field pixels, the centre of the first pixel is 0
    float y = 0;  ///< row in field pixels, from the top
    float u = 0;  ///< flow at the point, pixels per frame
    float v = 0;
    SeedFlags flags{};  ///< whether the brick that the frame falls in makes geometry of it (§6)

    friend bool operator==(const Seed&, const Seed&) = default;
};

/// What the video sub-system gives for one frame.
struct Field {
    std::int64_t index = 0;        ///< of the frame in the clip
    double pts = 0;                ///< seconds
    Plane<std::uint8_t> scalar;    ///< 0 = uninteresting
    Flow flow;                     ///< empty where no flow was asked for; else 0 far from any object, unless asked for
    std::vector<Seed> seeds;       ///< empty where no flow was asked for
    Plane<std::uint8_t> second{};  ///< what a second filter gives; empty where none was asked for
};

}  // namespace vvr::fields
