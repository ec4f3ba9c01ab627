#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/fields/field.h"

namespace vvr::bricks {

/// The optical flow at some frames of the window: a vector field over (column, row, frame), which tracelines follow
/// (§5.2). Half floats: their 11 bits are finer than any estimate of flow, in half the memory.
class FlowVolume {
  public:
    /// Keeps the flow of `frame`, a later one than those before, all of one size.
    void add(std::int64_t frame, const fields::Flow& flow);

    /// Forgets the frames for which `gone` is true.
    void erase_if(const std::function<bool(std::int64_t)>& gone);

    /// Forgets the frames before `frame`, which is frame 0 from now on.
    void drop_front(std::int64_t frame);

    bool empty() const { return layers_.empty(); }
    std::size_t layers() const { return layers_.size(); }
    std::size_t bytes() const;

    /// (u, v) in field pixels per frame at (column, row, frame), linear between pixel centres and between the frames
    /// that are kept; beyond the outermost ones, theirs. Zero where nothing is kept.
    glm::dvec2 at(const glm::dvec3& point) const;

  private:
    struct Layer {
        std::int64_t frame = 0;
        Plane<std::uint32_t> packed;  ///< u in the low half, v in the high one
    };

    std::vector<Layer> layers_;
};

}  // namespace vvr::bricks
