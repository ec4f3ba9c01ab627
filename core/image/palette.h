#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/image/picture.h"

namespace vvr::image {

/// A palette of up to 256 colours for a picture.
class Palette {
  public:
    using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

    /// Chooses the colours by median cut: it splits the box of colours with the largest error.
    explicit Palette(const Picture& picture);

    const std::vector<Colour>& colours() const { return colours_; }

    /// The index of the nearest colour.
    std::uint8_t nearest(const Rgba& pixel);

  private:
    std::vector<Colour> colours_;
    std::vector<int> known_;  ///< cached results of `nearest` by the colour's upper bits; -1 = none
};

}  // namespace vvr::image
