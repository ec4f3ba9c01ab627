#pragma once

#include "core/fields/field.h"
#include "core/image/picture.h"
#include "core/video/frame.h"

namespace vvr::app {

/// The picture of one frame's fields, and whether its captions found a font.
struct Inspection {
    image::Picture picture;
    bool captions = true;
};

/// Fig. 4: the difference object, the flow as green lines and the seeds, side by side over the dimmed frame.
/// \param frame in colour
Inspection inspect(const video::Frame& frame, const fields::Field& field);

}  // namespace vvr::app
