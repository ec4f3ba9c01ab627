#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/bricks/volume.h"
#include "core/space/layout.h"

namespace vvr::scene {

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

}  // namespace vvr::scene
