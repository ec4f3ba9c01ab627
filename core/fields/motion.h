#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/base/plane.h"
#include "core/fields/field.h"

namespace vvr::fields {

/// Copies to `changed` what of `object` lies in tiles of 8 × 8 pixels that differ between two frames by more than the
/// camera's noise, or next to one. The noise is learnt from the quiet tiles of the same frames.
/// \param other, here the frames, smoothed; the object is that of `here`
void mark_changes(const Plane<std::uint8_t>& other, const Plane<std::uint8_t>& here, const Plane<std::uint8_t>& object,
                  Plane<std::uint8_t>& changed);

/// Tells of the fields of a clip, in order, whether anything moves. What lies there without moving, a bag that was
/// left, doesn't count, nor does noise.
class MotionDetector {
  public:
    /// Whether something moves in this frame, or did so within the last second.
    bool operator()(const Field& field);

  private:
    struct Past {
        double pts = 0;
        std::vector<std::uint8_t> filling;
    };

    std::deque<Past> past_;
    std::optional<double> last_;  ///< seconds, when something moved
};

}  // namespace vvr::fields
