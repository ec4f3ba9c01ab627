#include "core/scene/glyph.h"

#include <array>
#include <cmath>
#include <numbers>

namespace vvr::scene {

namespace {

struct Ring {
    float z;
    float radius;
    glm::vec2 normal;  ///< outwards and along z
};

// The arrow's outline from tail to tip; a ring is repeated where the normal has an edge.
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
        if (ring == 1 || ring == 3 || ring == 5) continue;  // between a ring and its repetition is nothing
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = ring * n + i;
            const std::uint32_t b = ring * n + (i + 1) % n;
            mesh.indices.insert(mesh.indices.end(), {a, b, a + n, b, b + n, a + n});
        }
    }
    return mesh;
}

std::vector<Glyph> arrows(const bricks::Volume& volume, std::span<const bricks::FrameSeed> seeds,
                          const space::Layout& layout, const GlyphOptions& options) {
    std::vector<Glyph> glyphs;
    glyphs.reserve(seeds.size());
    for (const bricks::FrameSeed& at : seeds) {
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

}  // namespace vvr::scene
