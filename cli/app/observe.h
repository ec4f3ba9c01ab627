#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "cli/app/objects.h"
#include "cli/app/observer.h"
#include "cli/app/plan.h"
#include "cli/app/volume_paint.h"
#include "core/bricks/owners.h"
#include "core/bricks/volume.h"
#include "core/events/event_finder.h"
#include "core/fields/field_source.h"
#include "core/glance/portraits.h"
#include "core/video/frame.h"

// What is seen of a clip.
namespace vvr::app {

/// A frame and its number, counted from the volume's first.
struct KeyFrame {
    video::SharedFrame frame;
    std::int64_t number = 0;
};

/// What was seen of a clip, or of the window over it.
struct Observation {
    bricks::Volume volume;
    video::VideoInfo info{};
    Moment begin{};                                                     ///< of the first frame
    video::SharedFrame first = std::make_shared<const video::Frame>();  ///< at the volume's beginning
    video::SharedFrame last = first;                                    ///< and at its end
    std::vector<KeyFrame> keyframes{};                                  ///< between them
    std::int64_t first_brick = 0;                                       ///< of the volume, counted from the clip's
    std::optional<ToldEvents> events{};                                 ///< none where they were not looked for
    bricks::Identify identify = bricks::no_identities;                  ///< whose the voxels are
    glance::Crops crops{};                                              ///< stills of the objects
    Plane<Bgr> scene{};                                                 ///< without objects
    fields::FieldSummary summary{};

    Moment end() const { return {last->index, last->pts}; }
};

/// Reads all fields of a clip, once and in order.
/// \throws Error limit, not_video, io, usage
Observation observe(const Plan& plan, fields::FieldSource& source, Observer& observer);

/// What the plan needs of the fields of `frames` frames.
fields::FieldNeeds needs_of(const Plan& plan, const fields::FieldSource& source, std::int64_t frames);

/// Makes an observation of frames and their fields, as they come.
class Gathering {
  public:
    /// \param room of the volume; what it keeps the plan says
    Gathering(const Plan& plan, bricks::VolumeOptions room, fields::FieldNeeds needs);

    /// \param moves whether something moves in it, where layers are of unequal length
    /// \returns whose its pixels are
    const events::FrameLabels& add(const video::SharedFrame& frame, const fields::Field& field, bool moves = true);

    Observation seen;
    std::optional<events::EventFinder> finder;  ///< none where nobody follows objects

  private:
    bool keeps_crops_;
    VolumePaint paint_;
    events::FrameLabels labels_;  ///< of the newest field
};

}  // namespace vvr::app
