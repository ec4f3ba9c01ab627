#pragma once

#include <span>

#include <glm/glm.hpp>

#include "core/base/plane.h"

namespace vvr::space {

/// The viewer's direction. Azimuth 0 is in front of the open side; positive azimuths are to the right.
struct View {
    double azimuth = 0;     ///< degrees
    double elevation = 46;  ///< degrees above the floor
    double fov = 30;        ///< vertical field of view in degrees; 0 = orthographic
    double margin = 0.04;   ///< on each side, as a fraction of the picture
};

/// A camera in P-space (left-handed).
struct Camera {
    glm::dvec3 eye{0};
    glm::dvec3 forward{0, 0, 1};  ///< unit length
    glm::dmat4 view{1};           ///< P-space to eye space, z forward
    glm::dmat4 projection{1};     ///< eye space to clip space
    bool perspective = true;

    glm::dmat4 clip_from_p() const { return projection * view; }

    /// The camera that shows only `part` of a picture of size `picture`.
    Camera cropped(const PixelBox& part, Size picture) const;

    /// The inverse of `cropped`: the camera that shows this one's view in `part` of a picture of size `picture`.
    Camera within(const PixelBox& part, Size picture) const;

    /// Width of a pixel of `picture` at the depth of `p`, in P-space units.
    double pixel_size(const glm::dvec3& p, Size picture) const;

    /// Projects a point of P-space to pixels: column, and row from the top; pixel centres are at .5.
    glm::dvec2 pixel(const glm::dvec3& p, Size picture) const;
};

/// The camera in direction `view` that shows all `points` as large as possible.
Camera fit_camera(const View& view, std::span<const glm::dvec3> points, Size picture);

}  // namespace vvr::space
