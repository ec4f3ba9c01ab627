#include "core/image/draw.h"

#include <algorithm>
#include <cmath>

namespace vvr::image {

void draw_line(Picture& picture, const glm::dvec2& from, const glm::dvec2& to, double width, const Rgba& colour) {
    Plane<Rgba>& pixels = picture.pixels;
    const double reach = width / 2 + 1;
    const auto low = [reach](double a, double b) {
        return std::max(0, static_cast<int>(std::floor(std::min(a, b) - reach)));
    };
    const auto high = [reach](double a, double b, int side) {
        return std::min(side - 1, static_cast<int>(std::ceil(std::max(a, b) + reach)));
    };
    const glm::dvec2 along = to - from;
    const double squared = glm::dot(along, along);
    for (int j = low(from.y, to.y); j <= high(from.y, to.y, pixels.height()); ++j) {
        for (int i = low(from.x, to.x); i <= high(from.x, to.x, pixels.width()); ++i) {
            const glm::dvec2 point(i, j);
            const double at = squared > 0 ? std::clamp(glm::dot(point - from, along) / squared, 0.0, 1.0) : 0;
            const double cover = std::clamp(width / 2 + 0.5 - glm::distance(point, from + at * along), 0.0, 1.0);
            Rgba& pixel = pixels.at(i, j);
            const auto over = static_cast<float>(cover);
            pixel += over * (colour - pixel * colour.a);
        }
    }
}

}  // namespace vvr::image
