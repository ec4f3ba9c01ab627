#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/fields/field.h"

namespace vvr::fields {

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
