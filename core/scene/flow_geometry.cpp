#include "core/scene/flow_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vvr::scene {

namespace {

struct Ring {
    float z;
    float radius;
    glm::vec2 normal;  ///< radial and z component
};

// The arrow's profile from tail to tip. Rings are repeated at edges, where normals are discontinuous.
constexpr float shaft = 0.055F;
constexpr float head = 0.15F;
constexpr float neck = 0.58F;
constexpr std::array<Ring, 7> rings = {{
    {0, 0, {0, -1}},
    {0, shaft, {0, -1}},
    {0, shaft, {1, 0}},
    {neck, shaft, {1, 0}},
    {neck, shaft, {0, -1}},
    {neck, head, {0, -1}},
    {neck, head, {0.94F, 0.34F}},
}};

}  // namespace

GlyphMesh arrow_mesh(int sides) {
    GlyphMesh mesh;
    const auto add_ring = [&](const Ring& ring) {
        for (int i = 0; i < sides; ++i) {
            const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(sides);
            const glm::vec2 around = {std::cos(angle), std::sin(angle)};
            mesh.vertices.push_back({{around * ring.radius, ring.z}, {around * ring.normal.x, ring.normal.y}});
        }
    };
    for (const Ring& ring : rings) add_ring(ring);
    add_ring({1, 0, rings.back().normal});

    const auto n = static_cast<std::uint32_t>(sides);
    for (std::uint32_t ring = 0; ring < rings.size(); ++ring) {
        if (ring == 1 || ring == 3 || ring == 5) continue;  // no faces between a ring and its repetition
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = ring * n + i;
            const std::uint32_t b = ring * n + (i + 1) % n;
            mesh.indices.insert(mesh.indices.end(), {a, b, a + n, b, b + n, a + n});
        }
    }
    return mesh;
}

std::vector<Glyph> arrows(const volume::Volume& volume, std::span<const volume::FrameSeed> seeds,
                          const space::Layout& layout, const GlyphOptions& options) {
    std::vector<Glyph> glyphs;
    glyphs.reserve(seeds.size());
    for (const volume::FrameSeed& at : seeds) {
        const glm::dvec3 c = volume.c_of({at.seed.x, at.seed.y, static_cast<double>(at.frame)});
        const glm::dvec3 v_c = volume.c_vector({at.seed.u, at.seed.v, options.time_velocity});
        glm::dvec3 v_p = layout.basis(c).transform(v_c) * options.frames;
        const double length = glm::length(v_p);
        if (!(length > 0)) continue;
        if (length > options.cap) v_p *= options.cap / length;
        glyphs.push_back({glm::vec3(layout.p_from_c(c)), glm::vec3(v_p), std::hypot(at.seed.u, at.seed.v),
                          static_cast<float>(at.frame)});
    }
    return glyphs;
}

namespace {

/// How far the segment from `from`, inside the box, to `to` stays inside it, as a share 0..1.
double inside_share(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& low, const glm::dvec3& high) {
    double share = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double length = to[axis] - from[axis];
        if (to[axis] > high[axis]) share = std::min(share, (high[axis] - from[axis]) / length);
        if (to[axis] < low[axis]) share = std::min(share, (low[axis] - from[axis]) / length);
    }
    return share;
}

/// Appends a line to the buffer. Its points are at least `spacing` apart, except for the last.
void append(Tracelines& lines, const std::vector<TraceVertex>& points, double spacing) {
    const std::size_t begin = lines.size();
    float length = 0;
    lines.push_back(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) {
        const float step = glm::distance(points[i].p, lines.back().p);
        const bool last = i + 1 == points.size();
        if (step == 0 || (step < spacing && !last)) continue;
        length += step;
        lines.push_back(points[i]);
        lines.back().along = length;
    }
    if (length == 0) {
        lines.resize(begin);
        return;
    }
    for (std::size_t i = begin; i < lines.size(); ++i) {
        lines[i].along /= length;
        lines[i].length = length;
    }
}

}  // namespace

std::vector<glm::dvec3> trace(const volume::Volume& volume, const glm::dvec3& start, const TraceOptions& options) {
    const glm::dvec3 low(-0.5);
    const glm::dvec3 high = glm::dvec3(volume.size().width, volume.size().height,
                                       volume.is_nonuniform() ? volume.frames() : volume.layers() * volume.step()) -
                            0.5;
    std::vector<glm::dvec3> points = {start};
    for (int i = 0; i < options.steps; ++i) {
        const glm::dvec3 from = points.back();
        const glm::dvec2 flow = volume.flow().at(from);
        const glm::dvec3 step = glm::dvec3(flow, options.time_velocity) * options.dt;
        if (glm::length(flow) < options.rest || !(glm::length(step) > 0)) break;
        const double share = inside_share(from, from + step, low, high);
        points.push_back(glm::clamp(from + share * step, low, high));
        if (share < 1) break;
    }
    return points;
}

Tracelines tracelines(const volume::Volume& volume, std::span<const volume::FrameSeed> seeds,
                      const space::Layout& layout, const TraceOptions& options) {
    Tracelines lines;
    std::vector<TraceVertex> points;
    for (const volume::FrameSeed& at : seeds) {
        points.clear();
        const glm::dvec3 start = {at.seed.x, at.seed.y, static_cast<double>(at.frame)};
        for (const glm::dvec3& point : trace(volume, start, options)) {
            const auto speed = static_cast<float>(glm::length(volume.flow().at(point)));
            points.push_back(
                {glm::vec3(layout.p_from_c(volume.c_of(point))), 0, 0, speed, static_cast<float>(point.z)});
        }
        append(lines, points, options.spacing);
    }
    return lines;
}

Plane<std::uint8_t> zebra_texels() {
    // Amplitude before clipping to black and white: larger values sharpen the borders.
    constexpr double contrast = 3;
    Plane<std::uint8_t> texels({64, 1});
    for (int i = 0; i < texels.width(); ++i) {
        const double at = (i + 0.5) / texels.width();
        const double wave = contrast * std::sin(2 * std::numbers::pi * at);
        texels.at(i, 0) = static_cast<std::uint8_t>(std::lround(255 * std::clamp(0.5 + wave / 2, 0.0, 1.0)));
    }
    return texels;
}

}  // namespace vvr::scene
