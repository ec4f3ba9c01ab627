#pragma once

#include <array>
#include <cstdint>

#include "core/base/plane.h"
#include "core/tracking/event.h"
#include "core/tracking/patch.h"

namespace vvr::tracking {

/// Counts how often each pixel became part of an object, with exponential decay. Tape in the wind, leaves and the
/// digits of a camera's clock change the same pixels again and again; a passing object changes each pixel once.
class Flicker {
  public:
    void add(const Plane<std::uint8_t>& field, const Moment& now);

    /// The mean count over the pixels of a patch.
    double of(const Patch& patch) const;

  private:
    double faded_ = 0;            ///< seconds: the time of the last decay
    Plane<std::uint8_t> before_;  ///< the last field
    Plane<std::uint8_t> counts_;  ///< in eighths
};

/// Finds since when each pixel has kept about the same value. For a bag this is the moment when it was put down, even
/// if it could not be distinguished from the person then.
class Steadiness {
  public:
    struct Pixel {
        Moment since;             ///< valid where `level` is not 0
        std::uint8_t level = 0;   ///< the steady value; 0 = no object
        std::uint8_t misses = 0;  ///< recent fields with another value, counted double
    };

    void add(const Plane<std::uint8_t>& field, const Moment& now);

    const Pixel& at(int i, int j) const { return pixels_.at(i, j); }

    /// Whether a value equals `level` except for noise and a codec's block edges.
    static bool alike(std::uint8_t value, std::uint8_t level);

  private:
    static constexpr std::size_t most_misses = 3;

    void add(std::uint8_t value, Pixel& pixel, const Moment& now) const;

    std::array<Moment, most_misses> last_{};  ///< the latest first
    Plane<Pixel> pixels_;
    Plane<std::uint8_t> levels_;  ///< copy of the pixels' levels, compact for speed
};

}  // namespace vvr::tracking
