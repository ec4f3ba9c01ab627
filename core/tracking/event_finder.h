#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/fields/planes.h"
#include "core/tracking/association.h"
#include "core/tracking/conclude.h"
#include "core/tracking/event.h"
#include "core/tracking/event_options.h"
#include "core/tracking/overlay.h"
#include "core/tracking/patch.h"
#include "core/tracking/track.h"

namespace vvr::tracking {

/// A portrait that is better than all previous ones of its track.
struct TrackPortrait {
    std::size_t track = 0;
    Portrait portrait;
};

/// What one field adds to the tracks.
struct TrackedFrame {
    FrameLabels labels;
    std::vector<TrackPortrait> portraits;  ///< those taken from this field
    std::optional<double> busy_since{};    ///< seconds: objects that are there now, and may be events, move since then
};

/// Finds the events of a clip in its fields, one field at a time. Memory depends on the number of events and on what is
/// visible at once.
///
/// Background subtraction has made the fields. Blobs of consecutive fields are tracked (`associate`). Tracks that meet
/// share a blob, and template matching finds each in it (`split_blob`). A part that becomes stationary begins when it
/// became still: for a bag, that is when it was put down, not when its bearer left. At the end the tracklets of each
/// object are joined (`link`), and objects are classified (`conclude`). What happens in a gap of the signal is unknown:
/// all tracks end there, and tracking starts again after it. So they do when the camera shows another view or changes
/// to infrared or back, as then nothing looks as before.
class EventFinder {
  public:
    explicit EventFinder(Size field, const EventOptions& options = {});

    /// \param now later than in the previous call
    TrackedFrame add(const FrameView& sight, const Moment& now);

    /// Forgets the tracks that ended before a time, so that a stream of days needs no more memory than one of minutes.
    /// `finish` returns only the others.
    /// \param seconds of the clip
    /// \param needed tracks that are kept
    void forget_ended_before(double seconds, const std::set<std::size_t>& needed);

    /// The largest share of the picture that has differed from the empty scene since a time.
    /// \param seconds of the clip; accurate to a second
    double largest_share_since(double seconds) const;

    /// Whether one of these tracks is still followed, and may go on.
    bool follows(std::span<const std::size_t> tracks) const;

    /// The empty scene that the fields are compared with. Without one, nothing is said to have been left or taken.
    /// \param scenes of the camera's views, at least one
    void set_scenes(std::vector<fields::Planes> scenes) { scenes_ = std::move(scenes); }

    /// Ends all tracks. To be called once, after the last field.
    Findings finish();

  private:
    bool follows_gap(const Moment& now) const;
    const fields::Planes& scene() const { return scenes_[view_]; }
    void restart();
    Plane<std::uint8_t> without_stationary(const FrameView& sight, const Moment& now);
    Assignment associate_movers(const Blobs& blobs, std::span<const Appearance> appearances, const Moment& now) const;
    void merge_fragments(Blobs& blobs, std::vector<Appearance>& appearances, const Assignment& assignment,
                         const FrameView& sight);
    void track_occluded(const FrameView& sight, Blobs& blobs, std::vector<Appearance>& appearances,
                        Assignment& assignment, const Moment& now);
    bool moves_again(std::size_t k, Blobs& blobs, std::vector<Appearance>& appearances, Assignment& assignment,
                     const FrameView& sight, const Moment& now);
    std::optional<std::size_t> bystander(const Track& thing) const;
    std::optional<std::size_t> about(const Track& standing) const;
    void drop_unconfirmed(std::vector<std::size_t>& chosen);
    void update_tracks(const FrameView& sight, const Blobs& blobs, std::span<const Appearance> appearances,
                       const Assignment& assignment, const Moment& now);
    void begin(const Patch& blob, const Appearance& appearance, std::optional<std::size_t> parent,
               std::vector<Track>& begun, const FrameView& sight, const Moment& now);
    void share(const Patch& blob, std::span<const std::size_t> chosen, const FrameView& sight, const Moment& now);
    void part_with_bearer(Track& track, const FrameView& sight, const Moment& now);
    void settle(const FrameView& sight, const Moment& now);
    void merge_stationary(Track& part);
    void end(Track& track, bool taken, const Moment& now);
    void keep(Tracklet tracklet);
    TrackedFrame tracked(const Moment& now) const;
    void record_share(const Plane<std::uint8_t>& field, const Moment& now);
    double share_at(const Moment& moment) const;

    EventOptions options_;
    Size field_;
    int reach_;
    int min_area_;
    std::size_t next_ = 0;  ///< number for the next track
    std::int64_t next_frame_ = 0;
    Steadiness steadiness_;
    Flicker flicker_;
    ClockFinder clocks_;
    std::vector<Track> tracks_;
    std::vector<Tracklet> ended_;
    std::vector<fields::Planes> scenes_ = std::vector<fields::Planes>(1);
    std::size_t view_ = 0;                                  ///< of the last frame
    std::deque<std::pair<double, double>> shares_;          ///< seconds and share of the picture, of recent fields
    std::deque<std::pair<double, double>> largest_shares_;  ///< the largest of each second, from its first field on
    Moment first_;
    Moment last_;
    std::vector<Stretch> stretches_;
    std::vector<condition::Interval> damaged_;  ///< as Span::damaged
};

}  // namespace vvr::tracking
