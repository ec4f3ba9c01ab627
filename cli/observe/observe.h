#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/observe/identify.h"
#include "cli/observe/objects.h"
#include "cli/plan/observer.h"
#include "cli/plan/plan.h"
#include "core/annotation/portraits.h"
#include "core/annotation/stills.h"
#include "core/annotation/time_strip.h"
#include "core/fields/field.h"
#include "core/fields/field_source.h"
#include "core/media/frame.h"
#include "core/media/frame_gaps.h"
#include "core/media/frame_span.h"
#include "core/tracking/event_finder.h"
#include "core/volume/owners.h"
#include "core/volume/volume.h"

// Reading a clip into an observation.
namespace vvr::app {

/// A frame and its number, counted from the start of the volume.
struct KeyFrame {
    media::SharedFrame frame;
    std::int64_t number = 0;
};

/// The data gathered from a clip, or from the window over it.
struct Observation {
    volume::Volume volume;
    media::VideoInfo info{};
    Moment begin{};                                                     ///< of the first frame
    media::SharedFrame first = std::make_shared<const media::Frame>();  ///< at the start of the volume
    media::SharedFrame last = first;                                    ///< at the end of the volume
    std::vector<KeyFrame> keyframes{};                                  ///< between these
    std::int64_t first_brick = 0;                           ///< number of the volume's first brick in the clip
    std::optional<ShownEvents> events{};                    ///< none = not searched for
    std::vector<TrackBox> track_boxes{};                    ///< of all frames, if they are written
    tracking::Findings findings{};                          ///< all that was found besides the chosen events
    std::vector<annotation::Period> not_chosen{};           ///< when objects were there whose events weren't chosen
    volume::VoxelStyleLookup identify = volume::no_styles;  ///< maps voxels to objects
    annotation::Crops crops{};                              ///< pictures of the objects
    std::vector<annotation::Still> stills{};                ///< of the whole clip, if the picture shows some
    std::optional<DetectorUse> detector{};                  ///< none = no detector looked at the events
    Plane<Bgr> scene{};                                     ///< the scene without objects
    std::vector<media::FrameGap> gaps{};                    ///< where frames are missing
    std::vector<condition::Interval> missing{};             ///< whose reason is known
    std::vector<condition::Interval> damaged{};             ///< when pictures were damaged
    std::vector<condition::Interval> other_light{};         ///< when much of the picture was in another light
    std::vector<std::string> relearnt{};                    ///< when the empty scene was learnt anew, one sentence each
    fields::FieldSummary summary{};

    Moment end() const { return {last->index, last->pts}; }
};

/// Checks that a clip gave frames. It had one when it was opened, so it must have changed if not.
/// \throws Error not_video
void require_frames(std::int64_t frames, const media::VideoInfo& info);

/// Looks at each frame while a clip is read. Either may be empty.
struct FrameWatch {
    std::function<void(const fields::FieldSource&)> begin{};  ///< called before the first frame, each time
    std::function<void(const media::SharedFrame&, const fields::Field&)> add{};
};

/// Reads all fields of a clip in order: once, or twice if its header promised far too many frames.
/// \throws Error limit, not_video, io, usage
Observation observe(const ObservePlan& plan, fields::FieldSource& source, Observer& observer,
                    const FrameWatch& watch = {});

/// What of the clip, or of the window over it, nobody looked at.
footage::Unseen unseen_of(const ObservePlan& plan, const Observation& seen);

/// What the plan needs from the fields of `frames` frames.
fields::FieldNeeds needs_of(const ObservePlan& plan, const fields::FieldSource& source, std::int64_t frames);

/// Takes the events that were chosen out of the findings, and keeps of the others only their times.
std::vector<tracking::Event> take_chosen_events(Observation& seen, const tracking::EventChoice& choice);

/// Computes the colours of a frame's voxels, if the volume stores colours.
class VoxelColours {
  public:
    /// \param plan must outlive this object
    explicit VoxelColours(const ObservePlan& plan);

    /// Empty if voxels have no colours of their own. Valid until the next call.
    const Plane<Bgr>& operator()(const media::Frame& frame, const fields::Field& field);

  private:
    Bgr colour_of_flow(float u, float v) const;

    const ObservePlan& plan_;
    std::array<Bgr, 256> of_value_{};
    Plane<Bgr> painted_;
};

/// Builds an observation from frames and their fields.
class ObservationBuilder {
  public:
    /// \param room size of the volume; the plan decides what it stores
    ObservationBuilder(const ObservePlan& plan, volume::VolumeOptions room, fields::FieldNeeds needs);

    /// \returns the objects of its pixels
    const tracking::FrameLabels& add(const media::SharedFrame& frame, const fields::Field& field);

    /// Takes what was found, and removes the camera's clock from the volume.
    void set_findings(tracking::Findings findings);

    /// Lets the detector look at the events that were found, if there is one.
    void identify();

    /// Takes the stills that were kept.
    void take_stills();

    /// Gives the empty scene to the search for events. It refers to this object.
    fields::SceneSink scene_sink();

    /// Finds people, vehicles and animals in whole frames, so that the empty scene is without them. Empty without a
    /// detector. It refers to this object.
    fields::LivingFinder living_finder();

    Observation seen;
    std::optional<tracking::EventFinder> finder;  ///< none = objects are not tracked

  private:
    void add_still(const media::SharedFrame& frame);

    media::FrameGaps find_gap_;
    const ObservePlan& plan_;
    bool keeps_crops_;
    bool keeps_boxes_;
    VoxelColours voxel_colours_;
    tracking::FrameLabels labels_;  ///< of the last field
    std::optional<annotation::Stills> stills_;
    std::optional<ObjectClassifier> classifier_;
};

}  // namespace vvr::app
