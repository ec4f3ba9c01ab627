#pragma once

#include "cli/app/job.h"
#include "core/labels/ruler.h"
#include "core/labels/sheet.h"
#include "core/space/camera.h"
#include "core/space/layout.h"

namespace vvr::app {

/// The positions of the volume and of the text around it in a picture.
struct Framing {
    labels::Sheet sheet;
    space::Camera camera;   ///< for the whole picture
    labels::TimeEdge edge;  ///< along which the ruler runs
    double half_pixel = 0;  ///< half the diagonal of the largest pixel that shows the volume, in P-space units
};

/// \param field_size of the frames in the volume
Framing frame_volume(const RenderJob& job, const space::Layout& layout, Size field_size);

}  // namespace vvr::app
