#include "core/scene/scene.h"

namespace vvr::scene {

std::vector<LineSegment> cross_section(const space::Layout& layout, double t, const glm::vec4& colour) {
    const auto corner = [&](double x, double y) { return glm::vec3(layout.p_from_c({x, y, t})); };
    const glm::vec3 corners[] = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
    std::vector<LineSegment> border;
    for (std::size_t i = 0; i < 4; ++i) border.push_back({corners[i], corners[(i + 1) % 4], colour});
    return border;
}

std::vector<LineSegment> volume_outline(const space::Layout& layout, const glm::vec4& colour) {
    constexpr int steps = 96;
    std::vector<LineSegment> segments;
    const auto add = [&](const glm::dvec3& from, const glm::dvec3& to) {
        segments.push_back({glm::vec3(layout.p_from_c(from)), glm::vec3(layout.p_from_c(to)), colour});
    };
    for (int corner = 0; corner < 4; ++corner) {
        const double x = corner & 1;
        const double y = corner >> 1;
        for (int i = 0; i < steps; ++i) {
            add({x, y, static_cast<double>(i) / steps}, {x, y, static_cast<double>(i + 1) / steps});
        }
        add({x, 0, y}, {x, 1, y});  // upright edges at both ends
        add({0, x, y}, {1, x, y});
    }
    return segments;
}

}  // namespace vvr::scene
