#pragma once

#include <array>

#include "cli/app/plan.h"
#include "core/fields/field.h"
#include "core/video/frame.h"

namespace vvr::app {

/// Computes the colours of a frame's voxels, if the volume stores colours.
class VolumePaint {
  public:
    /// \param plan must outlive this object
    explicit VolumePaint(const Plan& plan);

    /// Empty if voxels have no colours of their own. Valid until the next call.
    const Plane<Bgr>& operator()(const video::Frame& frame, const fields::Field& field);

  private:
    Bgr colour_of_flow(float u, float v) const;

    const Plan& plan_;
    std::array<Bgr, 256> of_value_{};
    Plane<Bgr> painted_;
};

}  // namespace vvr::app
