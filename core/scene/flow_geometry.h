#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/space/layout.h"
#include "core/volume/volume.h"

namespace vvr::scene {

/// A vertex of the reference glyph, an arrow of length 1 along +z from the origin.
struct GlyphVertex {
    glm::vec3 position;
    glm::vec3 normal;
};

/// The reference glyph that is instanced at each seed (§5.2), with an index buffer (§6.2).
struct GlyphMesh {
    std::vector<GlyphVertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// An arrow from its seed to where the flow carries the seed.
struct Glyph {
    glm::vec3 from;    ///< P-space
    glm::vec3 vector;  ///< P-space, from the tail to the tip
    float speed;       ///< pixels per frame, for the colour
    float frame = 0;   ///< the seed's frame, counted from the volume's first
};

struct GlyphOptions {
    double frames = 8;         ///< length of the motion that an arrow shows
    double cap = 0.075;        ///< longest arrow in P-space units
    double time_velocity = 0;  ///< v_t of §5.2: frames of motion along time per frame
};

/// A shaft and a cone with `sides` sides.
GlyphMesh arrow_mesh(int sides = 10);

/// One arrow per seed, oriented by the transformed flow vector (e_x, e_y, e_t) at the seed (§5.2).
/// \param seeds the seeds of `volume` to draw
std::vector<Glyph> arrows(const volume::Volume& volume, std::span<const volume::FrameSeed> seeds,
                          const space::Layout& layout, const GlyphOptions& options);

/// A vertex of a traceline.
struct TraceVertex {
    glm::vec3 p;      ///< P-space
    float along;      ///< texture coordinate of §6.2.1: 0..1 along the line, by length
    float length;     ///< of the whole line, P-space units
    float speed;      ///< pixels per frame
    float frame = 0;  ///< counted from the volume's first
};

/// All tracelines in one vertex buffer (§6.2), concatenated. A line begins where `along` is 0.
using Tracelines = std::vector<TraceVertex>;

struct TraceOptions {
    double dt = 1;             ///< Δt of Eq. (2), frames
    int steps = 60;            ///< maximum number of Euler steps
    double time_velocity = 0;  ///< v_t of §5.2, frames per frame; 0 = a trace stays in its frame
    double rest = 0.1;         ///< pixels per frame; slower flow ends the trace. 0 = only zero-length steps end it
    double spacing = 0.004;    ///< minimum distance of stored points, P-space units
};

/// The path of a particle, integrated by Euler's method, Eq. (2): p_{i+1} = p_i + Δt v(p_i), v = (u, v, v_t). It ends
/// after the last step, where the flow is slower than `rest`, or exactly on the volume's border.
/// \param start column and row in field pixels, frame counted from the volume's first
/// \returns points in the same coordinates, `start` first
std::vector<glm::dvec3> trace(const volume::Volume& volume, const glm::dvec3& start, const TraceOptions& options);

/// Tracelines from `seeds`, mapped to P-space. Lines of zero length are left out.
/// \param seeds the seeds of `volume` to draw
Tracelines tracelines(const volume::Volume& volume, std::span<const volume::FrameSeed> seeds,
                      const space::Layout& layout, const TraceOptions& options);

/// One period of the zebra texture (§6.2.1) in a single row: a dark (0) and a bright (255) stripe of equal length with
/// soft borders.
Plane<std::uint8_t> zebra_texels();

}  // namespace vvr::scene
