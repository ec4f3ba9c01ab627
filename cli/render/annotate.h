#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/render/job.h"
#include "core/labels/lettering.h"
#include "core/labels/ruler.h"
#include "core/labels/sheet.h"
#include "core/space/camera.h"

// What is written and drawn around the volume in a picture.
namespace vvr {

/// Where the volume and the text around it are in a picture.
struct Framing {
    Sheet sheet;
    Camera camera;  ///< of the whole picture
    TimeEdge edge;  ///< along which the ruler runs
};

Framing frame_volume(const RenderJob& job, const Layout& layout);

/// What a picture says of what it shows.
struct Caption {
    std::string title;
    std::int64_t frames = 0;
    double begin = 0;    ///< seconds of the first frame in the clip
    double end = 0;      ///< seconds of the last frame
    bool still = false;  ///< nothing of the volume is visible
    WallClock clock{};   ///< when the clip began
};

/// The times that the ruler of a volume marks; none where it isn't shown.
std::vector<TimeTick> ticks_of(const RenderJob& job, const Framing& framing, const Volume& volume,
                               const WallClock& clock);

/// All text on a picture, and what belongs to it. Empty where there is no font.
/// \param ticks as `ticks_of` gives them
Lettering letter(const RenderJob& job, const Caption& caption, const Volume& volume, const Layout& layout,
                 const Framing& framing, const std::vector<TimeTick>& ticks);

/// Breaks of the ruler that are marked.
inline constexpr std::size_t breaks_shown = 48;

}  // namespace vvr
