#include "core/scene/theme.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vvr::scene {

namespace {

/// Converts 0xrrggbb.
constexpr glm::vec3 rgb(unsigned hex) {
    return {static_cast<float>(hex >> 16U & 255U) / 255, static_cast<float>(hex >> 8U & 255U) / 255,
            static_cast<float>(hex & 255U) / 255};
}

// Found by simulated annealing: far apart for normal and dichromatic vision, evenly spaced in lightness, with contrast
// to the background. Consecutive colours differ most, because few objects use only the first ones.
constexpr std::array on_white{rgb(0x073db7), rgb(0xff205b), rgb(0x4a733e), rgb(0xb28d1a),
                              rgb(0x580065), rgb(0x007bc7), rgb(0x6a2800), rgb(0xb0076c)};
constexpr std::array on_black{rgb(0x15d7e8), rgb(0xcd1786), rgb(0xffce77), rgb(0x17a523),
                              rgb(0xc724ff), rgb(0xdaf61c), rgb(0x8d99f2), rgb(0xff9297)};

constexpr std::array table{
    Theme{"light",
          "dark on white",
          {1, 1, 1},
          {0.12F, 0.14F, 0.17F},
          {0.42F, 0.45F, 0.50F},
          {0.55F, 0.58F, 0.62F},
          {0.10F, 0.12F, 0.16F, 0.17F},
          "blue",
          {0.98F, 0.72F, 0.20F},
          {0.84F, 0.16F, 0.10F},
          on_white,
          rgb(0xa9adb3)},
    Theme{"dark",
          "bright on near black, for screens",
          {0.07F, 0.08F, 0.10F},
          {0.93F, 0.94F, 0.96F},
          {0.60F, 0.64F, 0.70F},
          {0.40F, 0.44F, 0.50F},
          {0, 0, 0, 0.55F},
          "viridis",
          {1.00F, 0.84F, 0.45F},
          {1.00F, 0.38F, 0.28F},
          on_black,
          rgb(0x53585f)},
    Theme{"print",
          "black and grey on white",
          {1, 1, 1},
          {0, 0, 0},
          {0.30F, 0.30F, 0.30F},
          {0.35F, 0.35F, 0.35F},
          {0, 0, 0, 0.15F},
          "grey",
          {0.75F, 0.75F, 0.75F},
          {0.05F, 0.05F, 0.05F},
          on_white,
          rgb(0xacacac)},
};

}  // namespace

std::span<const Theme> themes() {
    return table;
}

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
    constexpr double right = 25;  // hue of rightwards, red; yellow is up, green left, blue down
    const double degrees = std::atan2(-direction.y, direction.x) * 180 / std::numbers::pi;
    return hue_colour(0.64, 0.18, right + degrees);
}

Bgr bgr_of(const glm::vec3& colour) {
    const glm::vec3 level = glm::clamp(colour, 0.F, 1.F) * 255.F + 0.5F;
    return {static_cast<std::uint8_t>(level.b), static_cast<std::uint8_t>(level.g), static_cast<std::uint8_t>(level.r)};
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

namespace {

struct ObjectStateStyle {
    float extinction;  ///< factor on the transfer function's
    float toward_ink;  ///< blend from the object's colour to black, 0..1
};

// In the order of ObjectState. A stationary object stays in one place for long; stripes across time and a higher
// extinction tell it from a trail that runs along the arc.
constexpr std::array states{ObjectStateStyle{1, 0}, ObjectStateStyle{1.5F, 0}, ObjectStateStyle{3, 0.45F}};

// Leaves, rain and changes of light belong to no object. They are visible where there is nothing else, but fainter than
// objects. At a sixth, a whole frame of brighter light stays transparent.
constexpr float unowned_extinction = 1.0F / 6;

}  // namespace

std::uint8_t palette_index(int colour, ObjectState state) {
    return static_cast<std::uint8_t>(1 + colour * static_cast<int>(states.size()) + static_cast<int>(state));
}

ObjectState state_of(std::uint8_t index) {
    return static_cast<ObjectState>(index == 0 ? 0 : (index - 1) % static_cast<int>(states.size()));
}

std::vector<glm::vec4> object_palette(const Theme& theme) {
    std::vector<glm::vec4> palette{{theme.unowned, unowned_extinction}};
    for (const glm::vec3& colour : theme.objects) {
        for (const ObjectStateStyle& state : states) {
            palette.emplace_back(glm::mix(colour, glm::vec3(0), state.toward_ink), state.extinction);
        }
    }
    return palette;
}

}  // namespace vvr::scene
