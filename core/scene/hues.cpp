#include "core/scene/hues.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vvr::scene {

namespace {

float encoded(double linear) {
    const double within = std::clamp(linear, 0.0, 1.0);
    return static_cast<float>(within <= 0.0031308 ? 12.92 * within : 1.055 * std::pow(within, 1 / 2.4) - 0.055);
}

}  // namespace

glm::vec3 hue_colour(double lightness, double chroma, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    const double a = chroma * std::cos(angle);
    const double b = chroma * std::sin(angle);
    const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

glm::vec3 direction_colour(const glm::dvec2& direction) {
    constexpr double right = 25;  // the hue, red; then over yellow up, green left, blue down
    const double degrees = std::atan2(-direction.y, direction.x) * 180 / std::numbers::pi;
    return hue_colour(0.64, 0.18, right + degrees);
}

std::vector<glm::vec4> time_colours() {
    constexpr int steps = 256;
    std::vector<glm::vec4> colours;
    for (int i = 0; i < steps; ++i) {
        const double share = static_cast<double>(i) / (steps - 1);
        colours.emplace_back(hue_colour(0.40 + 0.32 * share, 0.17, 280 - 225 * share), 1);
    }
    return colours;
}

}  // namespace vvr::scene
