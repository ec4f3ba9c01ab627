#pragma once

#include "core/bricks/volume.h"
#include "core/glance/objects.h"
#include "core/scene/flow_geometry.h"
#include "core/space/camera.h"
#include "core/space/layout.h"

namespace vvr::glance {

/// Where the objects of a volume are in space, and in a camera's picture. The parts outlive it.
class Trails {
  public:
    Trails(const bricks::Volume& volume, const space::Layout& layout, const space::Camera& camera, Size picture)
        : volume_(volume), layout_(layout), camera_(camera), picture_(picture) {}

    /// Where an object was at a time of the clip, in P-space.
    glm::dvec3 point(const events::Event& event, double seconds) const;

    /// The same in the picture.
    glm::dvec2 pixel(const events::Event& event, double seconds) const {
        return camera_.pixel(point(event, seconds), picture_);
    }

  private:
    const bricks::Volume& volume_;
    const space::Layout& layout_;
    const space::Camera& camera_;
    Size picture_;
};

/// The largest box of the frame's shape in the open middle of a horseshoe that no part of the volume hides; empty where
/// there is none, as in a box.
/// \param area of the picture that it stays in
PixelBox hollow_of(const space::Layout& layout, const space::Camera& camera, Size picture, const PixelBox& area,
                   double aspect);

/// Arrows along the paths of the objects, at equal distances in time: which way each of them went. None where it stood.
/// \param length of an arrow, P-space units
std::vector<scene::Glyph> direction_arrows(const Objects& objects, const bricks::Volume& volume,
                                           const space::Layout& layout, double length);

}  // namespace vvr::glance
