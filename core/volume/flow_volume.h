#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/fields/field.h"

namespace vvr::volume {

/// The optical flow at some frames of the window: a vector field over (column, row, frame), which tracelines follow
/// (§5.2). Stored as half floats, whose 11 bits exceed the accuracy of optical flow.
class FlowVolume {
  public:
    /// Adds the flow of `frame`, which must be later than the previous ones. All flows have the same size.
    void add(std::int64_t frame, const fields::Flow& flow);

    /// Removes the frames for which `gone` returns true.
    void erase_if(const std::function<bool(std::int64_t)>& gone);

    /// Removes the frames before `frame`, which becomes frame 0.
    void drop_front(std::int64_t frame);

    bool empty() const { return layers_.empty(); }
    std::size_t layers() const { return layers_.size(); }
    std::size_t bytes() const;

    /// (u, v) in field pixels per frame at (column, row, frame). Interpolates linearly between pixel centres and
    /// between stored frames, and is constant beyond them. Zero if no frame is stored.
    glm::dvec2 at(const glm::dvec3& point) const;

  private:
    struct Layer {
        std::int64_t frame = 0;
        Plane<std::uint32_t> packed;  ///< u in the low 16 bits, v in the high 16 bits
    };

    std::vector<Layer> layers_;
};

}  // namespace vvr::volume
