#include "core/tracking/difference.h"

#include <algorithm>
#include <cmath>

#include "core/tracking/appearance.h"

namespace vvr::tracking {

Difference difference_of(const Patch& patch, const FrameView& sight, const fields::Planes& scene) {
    const Size size = sight.field.size();
    const PixelBox box = intersection(patch.box, {0, 0, size.width, size.height});
    const Patch all{box, Plane<std::uint8_t>(box.size(), 1), box.width() * box.height(), {}};
    const FrameView empty{sight.field, scene.grey, scene.colour};
    double both = 0;
    double here = 0;
    double there = 0;
    for_each_pixel(patch, [&](int i, int j, std::uint8_t) {
        if (i < 1 || j < 1 || i + 1 >= size.width || j + 1 >= size.height) return;
        const auto gradient = [&](const FrameView& view) {
            return glm::dvec2(view.brightness(i + 1, j) - view.brightness(i - 1, j),
                              view.brightness(i, j + 1) - view.brightness(i, j - 1));
        };
        const glm::dvec2 of_frame = gradient(sight);
        const glm::dvec2 of_scene = gradient(empty);
        both += glm::dot(of_frame, of_scene);
        here += glm::dot(of_frame, of_frame);
        there += glm::dot(of_scene, of_scene);
    });
    return {distance(Appearance(all, sight), Appearance(all, empty)), both / std::sqrt(std::max(1.0, here * there))};
}

}  // namespace vvr::tracking
