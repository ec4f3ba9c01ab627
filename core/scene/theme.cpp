#include "core/scene/theme.h"

#include <array>

namespace vvr::scene {

namespace {

/// Of #rrggbb.
constexpr glm::vec3 rgb(unsigned hex) {
    return {static_cast<float>(hex >> 16U & 255U) / 255, static_cast<float>(hex >> 8U & 255U) / 255,
            static_cast<float>(hex & 255U) / 255};
}

// Searched for by simulated annealing: far from each other for normal and for dichromatic eyes, in even steps of
// lightness, far enough from the background. Those that follow each other here differ most, as few objects take the
// first ones.
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

}  // namespace vvr::scene
