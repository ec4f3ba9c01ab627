#pragma once

#include "core/scene/scene.h"
#include "core/volume/volume.h"
#include "gl/renderer.h"

namespace vvr::test {

/// Every voxel has the value 255.
volume::Volume full_volume(Size size, int layers);

/// A few soft balls on winding paths, mostly empty, as difference volumes are.
volume::Volume wandering_balls(Size size, int layers);

/// The same with all that isn't held.
Plane<std::uint8_t> whole(const volume::SparsePlane& sparse);

/// What `draw_volume` needs beyond its volume.
struct Shot {
    std::string layout = "horseshoe";
    std::string backend = "software";
    int bricks = 4;
    gl::RenderOptions options;
    scene::TransferFunction transfer = scene::default_transfer_function();
    scene::Scene scene;
};

struct Drawn {
    Plane<glm::vec4> picture;
    space::Camera camera;

    /// The pixel at which a point in P-space is seen.
    glm::vec4 at(const glm::dvec3& p) const {
        const glm::dvec2 pixel = camera.pixel(p, picture.size());
        return picture.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
    }
};

Drawn draw_volume(const volume::Volume& volume, Shot shot);

}  // namespace vvr::test
