#pragma once

#include <array>

#include "cli/app/colour.h"
#include "cli/app/job.h"
#include "core/fields/field.h"
#include "core/video/frame.h"
#include "gl/render_options.h"

namespace vvr::app {

/// The transfer function whose colours a second filter's values have: the one that was asked for, else the filter's
/// own, else one that all eyes tell apart.
scene::TransferFunction second_transfer_of(const RenderJob& job);

/// Gives each voxel of a frame its colour, where the volume has such.
class VolumePaint {
  public:
    /// \param job outlives this
    explicit VolumePaint(const RenderJob& job);

    /// Empty where the job's voxels have no colours of their own. It is valid until the next call.
    const Plane<Bgr>& operator()(const video::Frame& frame, const fields::Field& field);

  private:
    Bgr colour_of_flow(float u, float v) const;

    const RenderJob& job_;
    const ColourRow& row_;
    std::array<Bgr, 256> of_value_{};
    Plane<Bgr> painted_;
};

}  // namespace vvr::app
