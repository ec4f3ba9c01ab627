#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/events/association.h"
#include "core/events/conclude.h"
#include "core/events/event.h"
#include "core/events/event_options.h"
#include "core/events/patch.h"
#include "core/events/track.h"
#include "core/fields/planes.h"

namespace vvr::events {

/// A portrait that is better than all before of the same track.
struct TrackPortrait {
    std::size_t track = 0;
    Portrait portrait;
};

/// What a field told of the tracks.
struct TrackedFrame {
    FrameLabels labels;
    std::vector<TrackPortrait> portraits;  ///< those that are of this field
};

/// Finds the events of a clip in its fields, one after the other; memory depends on what is to be seen at a time, and
/// on the number of events.
///
/// Blobs of consecutive fields are followed as tracks (`associate`). Those that meet share a blob, in which each is
/// looked for by what it was (`share_blob`). A part that stands still began when it became still, which is when a bag
/// was put down and not when whoever brought it had gone. At the end tracks of one object are joined (`link`), and it
/// is told what each of them was (`conclude`). Nobody knows what happened while there was no signal: at a gap all
/// tracks end, and what is there after it is followed anew.
class EventFinder {
  public:
    explicit EventFinder(Size field, const EventOptions& options = {});

    /// \param now later than in the call before
    TrackedFrame add(const FrameView& sight, const Moment& now);

    /// Drops what is known of the objects that had gone by then, so that a stream of days needs no more memory than one
    /// of minutes. `finish` tells of the others.
    /// \param seconds of the clip
    void forget_ended_before(double seconds) {
        std::erase_if(ended_, [&](const Tracklet& tracklet) { return tracklet.end.at.seconds < seconds; });
    }

    /// The events, by their first times. To be called once, after the last field.
    /// \param scene the empty scene that the fields were compared with; empty where there is none
    std::vector<Event> finish(const fields::Planes& scene = {});

  private:
    bool follows_gap(const Moment& now) const;
    void restart();
    Plane<std::uint8_t> without_stationary(const FrameView& sight, const Moment& now);
    Assignment associate_movers(const Blobs& blobs, std::span<const Appearance> looks, const Moment& now) const;
    void merge_fragments(Blobs& blobs, std::vector<Appearance>& looks, const Assignment& assignment,
                         const FrameView& sight);
    void track_occluded(const FrameView& sight, Blobs& blobs, std::vector<Appearance>& looks, Assignment& assignment,
                        const Moment& now);
    bool resumes_motion(std::size_t k, Blobs& blobs, std::vector<Appearance>& looks, Assignment& assignment,
                        const FrameView& sight, const Moment& now);
    std::optional<std::size_t> about(const Track& standing) const;
    void drop_unconfirmed(std::vector<std::size_t>& chosen);
    void update_tracks(const FrameView& sight, const Blobs& blobs, std::span<const Appearance> looks,
                       const Assignment& assignment, const Moment& now);
    void begin(const Patch& blob, const Appearance& look, std::optional<std::size_t> parent, std::vector<Track>& begun,
               const FrameView& sight, const Moment& now);
    void share(const Patch& blob, std::span<const std::size_t> chosen, const FrameView& sight, const Moment& now);
    void settle(const FrameView& sight, const Moment& now);
    void merge_stationary(Track& part, const FrameView& sight);
    void end(Track& track, bool taken, const Moment& now);
    TrackedFrame tracked(const Moment& now) const;

    EventOptions options_;
    Size field_;
    int reach_;
    int min_area_;
    std::size_t next_ = 0;  ///< number of the next track
    std::int64_t next_frame_ = 0;
    Steadiness steadiness_;
    Flicker flicker_;
    std::vector<Track> tracks_;
    std::vector<Tracklet> ended_;
    Moment first_;
    Moment last_;
    std::vector<Stretch> stretches_;
};

}  // namespace vvr::events
