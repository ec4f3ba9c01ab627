#pragma once

#include <array>

#include "cli/app/plan.h"
#include "core/fields/field.h"
#include "core/video/frame.h"

namespace vvr::app {

/// Gives each voxel of a frame its colour, where the volume has such.
class VolumePaint {
  public:
    /// \param plan outlives this
    explicit VolumePaint(const Plan& plan);

    /// Empty where voxels have no colours of their own. It is valid until the next call.
    const Plane<Bgr>& operator()(const video::Frame& frame, const fields::Field& field);

  private:
    Bgr colour_of_flow(float u, float v) const;

    const Plan& plan_;
    std::array<Bgr, 256> of_value_{};
    Plane<Bgr> painted_;
};

}  // namespace vvr::app
