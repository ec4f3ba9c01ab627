#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "core/plane.h"
#include "core/scene/glyph.h"
#include "core/scene/traceline.h"
#include "core/space/layout.h"

namespace vvr {

/// A straight line in P-space.
struct Segment {
    glm::vec3 from;
    glm::vec3 to;
    glm::vec4 colour;  ///< sRGB and opacity
};

/// A frame of the clip that stands in the volume at its time.
struct StandingFrame {
    double t = 0;  ///< t_C
    Plane<Bgr> picture;
    float opacity = 1;
    double frame = 0;  ///< counted from the volume's first
};

/// The geometry that is drawn with the volume.
struct Scene {
    std::vector<Glyph> arrows;
    Tracelines tracelines;
    std::vector<Segment> lines;
    std::vector<StandingFrame> frames;
};

/// The edges of the volume.
std::vector<Segment> volume_outline(const Layout& layout, const glm::vec4& colour);

}  // namespace vvr
