#pragma once

#include <span>

#include <glm/glm.hpp>

#include "core/base/plane.h"

namespace vvr::space {

/// Where the viewer is: at azimuth 0 in front of the open side, at positive azimuth further to the right.
struct View {
    double azimuth = 0;     ///< degrees
    double elevation = 46;  ///< degrees above the floor
    double fov = 30;        ///< vertical field of view in degrees; 0 = orthographic
    double margin = 0.04;   ///< part of the picture left free on each side
};

/// A camera in P-space (left-handed).
struct Camera {
    glm::dvec3 eye{0};
    glm::dvec3 forward{0, 0, 1};  ///< unit length
    glm::dmat4 view{1};           ///< P-space to eye space, z forward
    glm::dmat4 projection{1};     ///< eye space to clip space
    bool perspective = true;

    glm::dmat4 clip_from_p() const { return projection * view; }

    /// The same view of only a part of a picture of size `picture`.
    Camera cropped(const PixelBox& part, Size picture) const;

    /// The camera whose picture of size `picture` shows this one's in `part`, and more around it.
    Camera within(const PixelBox& part, Size picture) const;

    /// The side of a pixel of `picture` at the depth of a point, in P-space units.
    double pixel_side(const glm::dvec3& p, Size picture) const;

    /// Pixel position (column, row from the top; pixel centres at .5) of a point of P-space.
    glm::dvec2 pixel(const glm::dvec3& p, Size picture) const;
};

/// The camera that looks from `view`'s direction and holds all `points` as large as the picture allows.
Camera fit_camera(const View& view, std::span<const glm::dvec3> points, Size picture);

}  // namespace vvr::space
