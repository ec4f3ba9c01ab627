#include "core/scene/theme.h"

#include <array>

namespace vvr {

namespace {

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
          {0.84F, 0.16F, 0.10F}},
    Theme{"dark",
          "bright on near black, for screens",
          {0.07F, 0.08F, 0.10F},
          {0.93F, 0.94F, 0.96F},
          {0.60F, 0.64F, 0.70F},
          {0.40F, 0.44F, 0.50F},
          {0, 0, 0, 0.55F},
          "viridis",
          {1.00F, 0.84F, 0.45F},
          {1.00F, 0.38F, 0.28F}},
    Theme{"print",
          "black and grey on white",
          {1, 1, 1},
          {0, 0, 0},
          {0.30F, 0.30F, 0.30F},
          {0.35F, 0.35F, 0.35F},
          {0, 0, 0, 0.15F},
          "grey",
          {0.75F, 0.75F, 0.75F},
          {0.05F, 0.05F, 0.05F}},
};

}  // namespace

std::span<const Theme> themes() {
    return table;
}

}  // namespace vvr
