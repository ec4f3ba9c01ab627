#pragma once

#include <array>
#include <cstdint>

#include "core/base/plane.h"
#include "core/events/event.h"
#include "core/events/patch.h"

namespace vvr::events {

/// Counts how often each pixel came to be part of an object of late. Tape in the wind, leaves and the digits of a
/// camera's clock come and go at the same pixels; what walks through crosses each of them once.
class Flicker {
  public:
    void add(const Plane<std::uint8_t>& field, const Moment& now);

    /// The mean count of the pixels of a patch.
    double of(const Patch& patch) const;

  private:
    double faded_ = 0;            ///< seconds: when the counts were last made less
    Plane<std::uint8_t> before_;  ///< the last field
    Plane<std::uint8_t> counts_;  ///< in eighths
};

/// Knows of each pixel since when its value has been about the same: of an object that was put down while somebody
/// stood about it, that is when, though it was not to be told from the person then.
class Steadiness {
  public:
    struct Pixel {
        Moment since;             ///< of use where `level` is not 0
        std::uint8_t level = 0;   ///< the value that it has had; 0 = no object
        std::uint8_t misses = 0;  ///< of late, how often it was otherwise
    };

    void add(const Plane<std::uint8_t>& field, const Moment& now);

    const Pixel& at(int i, int j) const { return pixels_.at(i, j); }

    /// Whether a value counts as `level`: noise and the seams of a codec's blocks do.
    static bool alike(std::uint8_t value, std::uint8_t level);

  private:
    static constexpr std::size_t most_misses = 3;

    void add(std::uint8_t value, Pixel& pixel, const Moment& now) const;

    std::array<Moment, most_misses> last_{};  ///< times of the last fields, the latest first
    Plane<Pixel> pixels_;
    Plane<std::uint8_t> levels_;  ///< those of the pixels, closer together
};

}  // namespace vvr::events
