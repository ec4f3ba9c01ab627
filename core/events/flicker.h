#pragma once

#include <cstdint>

#include "core/events/event.h"
#include "core/events/patch.h"

namespace vvr::events {

/// Counts how often each pixel came to be part of an object of late. Tape in the wind, leaves and the digits of a
/// camera's clock come and go at the same pixels; what walks through crosses each of them once.
class Flicker {
  public:
    /// \param memory seconds after which an old count has fallen to a third
    explicit Flicker(double memory) : memory_(memory) {}

    void add(const Plane<std::uint8_t>& field, const Moment& now);

    /// The mean count of the pixels of a patch.
    double of(const Patch& patch) const;

  private:
    double memory_;
    double faded_ = 0;            ///< seconds: when the counts were last made less
    Plane<std::uint8_t> before_;  ///< the last field
    Plane<std::uint8_t> counts_;  ///< in eighths
};

}  // namespace vvr::events
