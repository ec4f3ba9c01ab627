#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace vvr::generator {

/// A number of 64 bits that depends on `value` alone and looks random.
std::uint64_t hash(std::uint64_t value);

/// `hash` as a number in [0, 1).
double unit(std::uint64_t value);

/// A pattern without period or edges that is known at every point of the plane, not only at pixels: a sum of waves.
/// It can be moved and turned by any amount without resampling.
class Texture {
  public:
    /// \param finest the shortest wavelength in pixels
    Texture(std::uint64_t seed, double finest, double coarsest);

    /// In [0, 1], 0.5 on average.
    double operator()(double x, double y) const;

  private:
    static constexpr std::size_t count = 16;
    std::array<double, count> kx_{};  // radians per pixel
    std::array<double, count> ky_{};
    std::array<double, count> phase_{};
};

}  // namespace vvr::generator
