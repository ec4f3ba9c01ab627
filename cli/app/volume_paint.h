#pragma once

#include <array>
#include <string>
#include <vector>

#include "cli/app/job.h"
#include "core/fields/field.h"
#include "core/video/frame.h"
#include "gl/render_options.h"

namespace vvr::app {

/// One row of the table of colours: where those of the volume come from. Its opacity is the transfer function's, of the
/// filter's values.
struct ColourRow {
    std::string name;
    std::string help;
    gl::VolumeColour drawn = gl::VolumeColour::transfer;
    bool needs_pictures = false;
    bool needs_flow = false;  ///< of each frame
    std::string filter{};     ///< a second filter, whose values have the colours; empty = none
};

/// The rows; the first leaves the choice open.
const std::vector<ColourRow>& colour_rows();

/// \throws Error usage when there is no such row
const ColourRow& find_colour(const std::string& name);

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
