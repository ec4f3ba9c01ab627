#pragma once

#include "core/bricks/volume.h"
#include "core/glance/objects.h"
#include "core/space/camera.h"
#include "core/space/layout.h"

namespace vvr {

/// Where the objects of a volume are in space, and in a camera's picture. The parts outlive it.
class Trails {
  public:
    Trails(const Volume& volume, const Layout& layout, const Camera& camera, Size picture)
        : volume_(volume), layout_(layout), camera_(camera), picture_(picture) {}

    /// Where an object was at a time of the clip, in P-space.
    glm::dvec3 point(const Event& event, double seconds) const;

    /// The same in the picture.
    glm::dvec2 pixel(const Event& event, double seconds) const {
        return camera_.pixel(point(event, seconds), picture_);
    }

  private:
    const Volume& volume_;
    const Layout& layout_;
    const Camera& camera_;
    Size picture_;
};

/// The largest box of the frame's shape in the open middle of a horseshoe that no part of the volume hides; empty where
/// there is none, as in a box.
/// \param area of the picture that it stays in
PixelBox hollow_of(const Layout& layout, const Camera& camera, Size picture, const PixelBox& area, double aspect);

}  // namespace vvr
