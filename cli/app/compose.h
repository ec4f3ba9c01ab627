#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cli/app/job.h"
#include "core/glance/objects.h"
#include "core/glance/portraits.h"
#include "core/labels/lettering.h"
#include "core/labels/ruler.h"
#include "core/labels/sheet.h"
#include "core/space/camera.h"

// What is written and drawn around the volume in a picture.
namespace vvr::app {

/// Where the volume and the text around it are in a picture.
struct Framing {
    labels::Sheet sheet;
    space::Camera camera;   ///< of the whole picture
    labels::TimeEdge edge;  ///< along which the ruler runs
};

/// \param aspect width of a frame by its height
Framing frame_volume(const RenderJob& job, const space::Layout& layout, double aspect = 4.0 / 3);

/// What a picture shows of the objects beside the volume.
struct Glance {
    glance::Objects objects;
    const glance::Crops* crops = nullptr;  ///< nothing where there are none
    Plane<Bgr> scene{};                    ///< without objects; empty where it isn't known
    Plane<Bgr> first{};                    ///< the first frame
    Plane<Bgr> last{};
    Size field{};
};

/// What a picture says of what it shows.
struct Caption {
    std::string title;
    std::int64_t frames = 0;
    double begin = 0;    ///< seconds of the first frame in the clip
    double end = 0;      ///< seconds of the last frame
    bool still = false;  ///< nothing of the volume is visible
    WallClock clock{};   ///< when the clip began
};

/// The objects of a clip that were there at some time from `begin` to `end`, in the colours of a look.
glance::Objects shown_objects(const LookOptions& look, std::span<const events::Event> events, double begin, double end,
                              const WallClock& clock);

/// The times that the ruler of a volume marks; none where it isn't shown.
std::vector<labels::TimeTick> ticks_of(const RenderJob& job, const Framing& framing, const bricks::Volume& volume,
                                       const WallClock& clock);

/// All text on a picture, and what belongs to it. Empty where there is no font.
/// \param ticks as `ticks_of` gives them
labels::Lettering letter(const RenderJob& job, const Caption& caption, const bricks::Volume& volume,
                         const space::Layout& layout, const Framing& framing,
                         const std::vector<labels::TimeTick>& ticks, const Glance& glance = {});

/// Breaks of the ruler that are marked.
inline constexpr std::size_t breaks_shown = 48;

}  // namespace vvr::app
