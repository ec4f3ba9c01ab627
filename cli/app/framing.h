#pragma once

#include "cli/app/job.h"
#include "core/labels/ruler.h"
#include "core/labels/sheet.h"
#include "core/space/camera.h"
#include "core/space/layout.h"

namespace vvr::app {

/// Where the volume and the text around it are in a picture.
struct Framing {
    labels::Sheet sheet;
    space::Camera camera;   ///< of the whole picture
    labels::TimeEdge edge;  ///< along which the ruler runs
    double half_pixel = 0;  ///< half of the diagonal of the largest pixel that shows the volume, in P-space units
};

/// \param field_size whose frames stand in the picture
Framing frame_volume(const RenderJob& job, const space::Layout& layout, Size field_size);

}  // namespace vvr::app
