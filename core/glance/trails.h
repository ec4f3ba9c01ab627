#pragma once

#include "core/bricks/volume.h"
#include "core/glance/objects.h"
#include "core/scene/flow_geometry.h"
#include "core/space/camera.h"
#include "core/space/layout.h"

namespace vvr::glance {

/// Positions of a volume's objects in P-space and in a camera's picture. The arguments must outlive it.
class Trails {
  public:
    Trails(const bricks::Volume& volume, const space::Layout& layout, const space::Camera& camera, Size picture)
        : volume_(volume), layout_(layout), camera_(camera), picture_(picture) {}

    /// An object's position in P-space at a time of the clip in seconds.
    glm::dvec3 point(const events::Event& event, double seconds) const;

    /// As `point`, in pixels of the picture.
    glm::dvec2 pixel(const events::Event& event, double seconds) const {
        return camera_.pixel(point(event, seconds), picture_);
    }

  private:
    const bricks::Volume& volume_;
    const space::Layout& layout_;
    const space::Camera& camera_;
    Size picture_;
};

/// The largest box for the map: in the open middle of a horseshoe, with the frame's shape, and clear of the volume.
/// Empty if there is none, as with the layout `box`.
/// \param area of the picture that may be used
/// \param aspect a frame's width divided by its height
PixelBox map_box(const space::Layout& layout, const space::Camera& camera, Size picture, const PixelBox& area,
                 double aspect);

/// Arrows along the objects' paths that show their directions, at equal intervals of time; none where an object is
/// stationary.
/// \param length of an arrow, P-space units
std::vector<scene::Glyph> direction_arrows(const Objects& objects, const bricks::Volume& volume,
                                           const space::Layout& layout, double length);

}  // namespace vvr::glance
