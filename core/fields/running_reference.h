#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/plane.h"
#include "core/fields/illumination.h"
#include "core/fields/planes.h"

namespace vvr::fields {

/// A reference that follows slow changes of the scene in a stream of any length. It doesn't adapt where there is an
/// object, so a bag left behind never becomes background. If somebody stands in the scene while it is learned and walks
/// away later, a ghost remains: an object that hasn't changed for `running.ghost`, with an edge in the reference and
/// none in the frame. A ghost becomes background.
class RunningReference {
  public:
    explicit RunningReference(const Planes& start);

    const Planes& now() const { return now_; }

    /// Adapts to a frame.
    /// \param light the change of light since the previous frame; it also applies behind objects
    /// \param seconds of the clip
    void adapt(const Planes& frame, const Plane<std::uint8_t>& object, const IlluminationChange& light, double seconds);

    /// The number of an object's pixels that haven't changed for `running.ghost` and are no ghost's; counted each
    /// second.
    int steady_pixels() const { return steady_pixels_; }

  private:
    void absorb_ghosts(const Planes& frame, const Plane<std::uint8_t>& object, int passed);

    Planes now_;
    std::optional<double> adapted_{};  ///< seconds of the last frame
    int since_check_ = 0;              ///< for ghosts, milliseconds
    int steady_pixels_ = 0;
    Plane<std::uint8_t> last_level_;   ///< grey level of each object pixel when it last changed
    Plane<std::uint16_t> steady_for_;  ///< milliseconds since then; 0 where there is no object
    std::vector<float> grey_;
    std::vector<float> colour_;
};

}  // namespace vvr::fields
