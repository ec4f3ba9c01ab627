#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/image/picture.h"

namespace vvr::image {

/// Up to 256 colours that represent those of a picture, for formats that hold no more.
class Palette {
  public:
    using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

    /// Chooses them by median cut: the colours are split where most pixels differ most.
    explicit Palette(const Picture& picture);

    const std::vector<Colour>& colours() const { return colours_; }

    /// The index of the nearest colour.
    std::uint8_t nearest(const Rgba& pixel);

  private:
    std::vector<Colour> colours_;
    std::vector<int> known_;  ///< earlier answers by the colour's upper bits; -1 = none
};

}  // namespace vvr::image
