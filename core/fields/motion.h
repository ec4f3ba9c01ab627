#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/base/plane.h"
#include "core/fields/field.h"

namespace vvr::fields {

/// Copies the changed part of `object` to `changed`: tiles of 8 × 8 pixels that differ between two frames by more than
/// the camera's noise, and their neighbours. The noise level comes from the quiet tiles of the same frames.
/// \param other, here the frames, smoothed; `object` belongs to `here`
void mark_changes(const Plane<std::uint8_t>& other, const Plane<std::uint8_t>& here, const Plane<std::uint8_t>& object,
                  Plane<std::uint8_t>& changed);

/// Detects whether anything moves in the fields of a clip, which come in order. Stationary objects, such as a bag left
/// behind, and noise don't count.
class MotionDetector {
  public:
    /// Whether something moves in this frame or moved within the last second.
    bool operator()(const Field& field);

  private:
    struct Past {
        double pts = 0;
        std::vector<std::uint8_t> occupancy;
    };

    std::deque<Past> past_;
    std::optional<double> last_;  ///< seconds: the time of the last motion
};

}  // namespace vvr::fields
