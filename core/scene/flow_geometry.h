#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
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

/// A point of a traceline, as in the vertex buffer.
struct TraceVertex {
    glm::vec3 p;      ///< P-space
    float along;      ///< the texture coordinate of §6.2.1: 0 at the line's first vertex, 1 at its last, by length
    float length;     ///< of the whole line, P-space units
    float speed;      ///< pixels per frame
    float frame = 0;  ///< counted from the volume's first
};

/// All tracelines in one vertex buffer (§6.2), one after the other: a line begins where `along` is 0.
using Tracelines = std::vector<TraceVertex>;

struct TraceOptions {
    double dt = 1;             ///< Δt of Eq. (2), frames
    int steps = 60;            ///< Euler steps at most
    double time_velocity = 0;  ///< v_t, frames moved along time per frame: 0 keeps a trace within its frame (§5.2)
    double rest = 0.1;  ///< pixels per frame; slower flow ends the trace: its particle has left what moves. 0: only
                        ///< a particle that stands still in time, too, ends there
    double spacing = 0.004;  ///< P-space units; nearer points are not stored
};

/// The way of a particle from `start` by Euler's method, Eq. (2): p_{i+1} = p_i + Δt v(p_i), v = (u, v, v_t). It ends
/// after the last step, where the flow rests, or exactly on the volume's border.
/// \param start column and row in field pixels, frame counted from the volume's first
/// \returns points like `start`, which is the first of them
std::vector<glm::dvec3> trace(const bricks::Volume& volume, const glm::dvec3& start, const TraceOptions& options);

/// A traceline from each seed, mapped to P-space. Lines without length are left out.
/// \param seeds of the volume, those of which geometry is made
Tracelines tracelines(const bricks::Volume& volume, std::span<const bricks::FrameSeed> seeds,
                      const space::Layout& layout, const TraceOptions& options);

/// One period of the texture that moves along tracelines (§6.2.1), from dark (0) to bright (255): a dark stripe and
/// a bright one of the same length with soft borders. A single row.
Plane<std::uint8_t> zebra_texels();

}  // namespace vvr::scene
