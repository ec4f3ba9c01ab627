#include "core/glance/trails.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vvr::glance {

glm::dvec3 Trails::point(const events::Event& event, double seconds) const {
    const glm::dvec2 place = place_at(event, seconds);
    glm::dvec3 c = volume_.c_of({place.x, place.y, 0});
    c.z = volume_.t_of_seconds(seconds);
    return layout_.p_from_c(c);
}

PixelBox hollow_of(const space::Layout& layout, const space::Camera& camera, Size picture, const PixelBox& area,
                   double aspect) {
    constexpr int samples = 128;
    const double middle = (area.left + area.right) / 2.0;
    // By distance from the middle, down to which row the volume reaches.
    struct Reach {
        double away;
        double row;
    };
    std::vector<Reach> reaches;
    double lowest_of_arc = 0;
    for (int i = 0; i <= samples; ++i) {
        const double t = static_cast<double>(i) / samples;
        for (const double x : {0.0, 0.5, 1.0}) {
            for (const double y : {0.0, 1.0}) {
                const glm::dvec2 at = camera.pixel(layout.p_from_c({x, y, t}), picture);
                reaches.push_back({std::abs(at.x - middle), at.y});
                if (i == samples / 2) lowest_of_arc = std::max(lowest_of_arc, at.y);
            }
        }
    }
    if (area.empty()) return {};
    const double gap = picture.height * 0.012;
    PixelBox best;
    for (int half = 20; half < area.width() / 2; half += 2) {
        double top = lowest_of_arc;
        for (const Reach& reach : reaches) {
            if (reach.away < half + gap) top = std::max(top, reach.row);
        }
        const int height = static_cast<int>(2 * half / aspect);
        const int first = static_cast<int>(std::ceil(top + gap));
        if (first + height + gap > area.bottom) break;
        best = {static_cast<int>(middle) - half, first, static_cast<int>(middle) + half, first + height};
    }
    return best;
}

}  // namespace vvr::glance
