#pragma once

#include "cli/render/render_clip.h"
#include "core/labels/lettering.h"
#include "core/labels/ruler.h"
#include "core/labels/sheet.h"
#include "core/space/camera.h"

// What stands around the volume in a picture.
namespace vvr {

/// Where the volume and the text about it lie in a picture.
struct Framing {
    Sheet sheet;
    Camera camera;  ///< of the whole picture
    TimeEdge edge;  ///< along which the ruler runs
};

Framing frame_volume(const RenderJob& job, const Layout& layout);

/// The moments that the ruler of a volume marks; none where it isn't shown.
std::vector<TimeTick> ticks_of(const RenderJob& job, const Framing& framing, const Volume& volume);

/// All that is written on a picture of what `report` tells of. Empty where no font is to be had.
Lettering letter(const RenderJob& job, const RenderReport& report, const Volume& volume, const Layout& layout,
                 const Framing& framing);

/// Breaks of the ruler that are marked.
inline constexpr std::size_t breaks_shown = 48;

}  // namespace vvr
