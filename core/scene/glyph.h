#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/bricks/volume.h"
#include "core/space/layout.h"

namespace vvr::scene {

/// A corner of the reference glyph: an arrow of length 1 along +z from the origin.
struct GlyphVertex {
    glm::vec3 position;
    glm::vec3 normal;
};

/// The reference geometry that is copied to each seed (§5.2), with an indexed vertex buffer (§6.2).
struct GlyphMesh {
    std::vector<GlyphVertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// One arrow: it starts at its seed and ends where the seed's flow carries it.
struct Glyph {
    glm::vec3 from;    ///< P-space
    glm::vec3 vector;  ///< P-space, from the tail to the tip
    float speed;       ///< pixels per frame, for the colour
    float frame = 0;   ///< of its seed, counted from the volume's first
};

struct GlyphOptions {
    double frames = 8;         ///< the arrow shows the motion over this many frames
    double cap = 0.075;        ///< longest arrow in P-space units
    double time_velocity = 0;  ///< v_t, frames moved along time per frame (§5.2)
};

/// Frustum and cone with `sides` sides.
GlyphMesh arrow_mesh(int sides = 10);

/// An arrow for each seed, oriented by the transformed vector (e_x, e_y, e_t) at the seed.
/// \param seeds of the volume, those of which geometry is made
std::vector<Glyph> arrows(const bricks::Volume& volume, std::span<const bricks::FrameSeed> seeds,
                          const space::Layout& layout, const GlyphOptions& options);

}  // namespace vvr::scene
