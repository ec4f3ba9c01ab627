#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <variant>

#include "core/tracking/appearance.h"
#include "core/tracking/claim.h"
#include "core/tracking/event_options.h"
#include "core/tracking/patch.h"
#include "core/tracking/path.h"
#include "core/tracking/pixel_history.h"
#include "core/tracking/tracklet.h"

namespace vvr::tracking {

// The states of a track, each with what is known only in it; docs/report.md has the diagram.

/// It has its own blob.
struct Moving {};

/// It shares a blob with others.
struct Merged {
    std::size_t near = 0;  ///< number of one of them, which may occlude it
};

/// No blob is at its predicted place.
struct Unseen {};

/// It is stationary: its steady pixels identify it, whoever stands near.
struct Standing {
    Stay stay;
    StillPicture picture;
    Moment whole_at{};                  ///< when it was last visible as a whole
    std::optional<Moment> alone_at{};   ///< when it was last seen, if nobody was near then
    std::optional<Moment> uncovered{};  ///< when less than half of its place first differed, since it was last seen
    std::optional<std::size_t> near{};  ///< number of the track that occludes it or is near it
};

struct Ended {};

using State = std::variant<Moving, Merged, Unseen, Standing, Ended>;

/// The track from which another one split.
struct Origin {
    std::optional<std::size_t> track{};  ///< number of the parent track
    double area = 0;                     ///< usual area of the parent, field pixels
    bool was_alone = false;              ///< whether the parent had its own blob
};

/// Where an object is, also while it is unseen, and where it goes.
struct Motion {
    glm::dvec2 place{};              ///< its centre
    Moment at{};                     ///< time of `place`
    glm::dvec2 velocity{};           ///< field pixels per second
    std::deque<PathPoint> recent{};  ///< the places that tell the velocity

    glm::dvec2 expected_at(const Moment& now) const { return place + velocity * (now.seconds - at.seconds); }
    glm::ivec2 shift_of(const Patch& patch, const Moment& now) const {
        return glm::ivec2(glm::round(expected_at(now) - patch.centre));
    }
};

/// An object that is tracked from field to field.
class Track {
  public:
    Track(std::size_t number, const Origin& origin, Size field) : origin_(origin), field_(field) {
        tracklet_.number = number;
        tracklet_.from = origin.track;
        tracklet_.area_of_parent = origin.was_alone ? origin.area : 0;
    }

    std::size_t number() const { return tracklet_.number; }
    std::optional<std::size_t> from() const { return tracklet_.from; }

    template <class S>
    bool is() const {
        return std::holds_alternative<S>(state_);
    }
    Standing* standing() { return std::get_if<Standing>(&state_); }  ///< null in another state
    bool found_standing() const { return is<Standing>() && tracklet_.settled->found_standing; }
    bool follows_blobs() const { return !is<Standing>() && !is<Ended>(); }

    /// Its pixels when it was last alone, shifted to its current place.
    const Patch& patch() const { return patch_; }
    /// Its pixels in the last field in which it was seen.
    const Patch& pixels() const { return pixels_; }
    const Appearance& appearance() const { return tracklet_.appearance; }
    const std::optional<Portrait>& portrait() const { return tracklet_.portrait; }
    const Moment& first() const { return tracklet_.begin.at; }
    const Moment& seen() const { return tracklet_.end.at; }
    glm::dvec2 usual_size() const { return tracklet_.size; }
    double usual_area() const { return tracklet_.area; }
    /// The usual area, or the last area alone if that is larger, as it is for an object that enters.
    double current_area() const { return std::max<double>(tracklet_.area, template_.patch.area); }

    /// Whether it has been seen for so long that it is no fragment or noise.
    bool is_confirmed() const { return tracklet_.is_confirmed(); }

    /// Since when it moves, or stands no longer than what is seen counts, seconds. None if it can't become an event
    /// yet: noise and leaves stay where they are.
    std::optional<double> busy_since(const Moment& now) const {
        const auto& settled = tracklet_.settled;
        if (is<Ended>() || !is_confirmed()) return {};
        const bool goes = 2 * glm::distance(bounds_min_, bounds_max_) >= thresholds.event.own_lengths * length();
        const bool rests = is<Standing>() && now.seconds - settled->since.seconds > thresholds.memory;
        if (rests || !(goes || settled)) return {};
        return std::max(first().seconds, moved_again_at_.seconds);
    }

    /// Whether its predicted centre is outside of the picture.
    bool is_outside() const {
        return patch_.centre.x < 0 || patch_.centre.y < 0 || patch_.centre.x >= field_.width ||
               patch_.centre.y >= field_.height;
    }

    /// Whether it began at the border of the picture and split from no other.
    bool entered_at_border() const { return !origin_.track && tracklet_.begin.at_border; }

    /// The shift of `patch` to the predicted place, whole pixels.
    glm::ivec2 shift_at(const Moment& now) const { return motion_.shift_of(patch_, now); }

    /// The shift of the template to the predicted place, whole pixels.
    glm::ivec2 template_shift_at(const Moment& now) const { return motion_.shift_of(template_.patch, now); }
    const Template& appearance_template() const { return template_; }

    /// Continues the track with a blob of its own.
    /// \param scene the empty scene; may be empty
    void update(const Patch& patch, const Appearance& appearance, const FrameView& sight, const fields::Planes& scene,
                const Moment& now);

    /// Lets the track share a blob. `update_merged` or `coast` continues it.
    /// \param near number of another track in the blob
    void merge(std::size_t near) {
        state_ = Merged{near};
        motion_.recent.clear();
    }

    /// Continues the track with its part of a shared blob.
    /// \returns whether the match is certain enough
    bool update_merged(const TemplateMatch& share, const Patch& blob, const FrameView& sight, const Moment& now);

    /// Continues the track without a detection, at its predicted place.
    void coast(const Moment& now);

    /// The track as it was when it left the picture, if what has been seen since is what it left behind: less than half
    /// of it, that came off the border in a blob of its own and has not been back. Nothing if it did not leave.
    const std::optional<Tracklet>& departed() const { return departed_; }

    /// Whether enough of its pixels have been steady for long enough.
    bool has_settled(const Steadiness& steadiness, const Flicker& flicker, const Moment& now) const;

    /// Makes the object stationary: from now on it consists of its steady pixels. If it split from another object, as a
    /// bag does, it begins when it became still.
    void settle(const Steadiness& steadiness, const Flicker& flicker, const FrameView& sight,
                const fields::Planes& scene, const Moment& now);

    /// Whether both are parts of one stationary object: side by side, and still within `stationary.stay` of each other.
    /// \param other stationary, as this one
    bool belongs_to(const Track& other) const;

    /// Adds a stationary part to this stationary object.
    void add_part(const Track& part);

    /// The share of a stationary object's pixels that are visible, 0 to 1.
    double visible_part(const Plane<std::uint8_t>& field) const;

    /// Continues a stationary object that is visible.
    /// \param whole nobody occludes it
    /// \param beside somebody is near it
    void update_stationary(const FrameView& sight, const fields::Planes& scene, const Moment& now, bool whole,
                           bool beside);

    /// When it became still. Only for a stationary object.
    const Moment& still_since() const { return tracklet_.settled->since; }

    /// Records the share of the picture that differed from the empty scene when it became still.
    void set_changed(double share) { tracklet_.settled->evidence.changed = share; }

    /// Whether it had left when its stay began: the place has an outline in the empty scene, and hardly one in the mean
    /// picture of the stay, as where a door or a thing is uncovered.
    bool shows_scene(const fields::Planes& scene) const;

    /// Ends the stationary state: the object moves.
    void move_again(const Moment& now);

    /// Adds a fragment with which the object began.
    void join(const Track& fragment);

    /// What it is if it ends now.
    /// \param taken it ends in the track that is near
    /// \param scene the empty scene; may be empty
    Tracklet tracklet(bool taken, const fields::Planes& scene, const Moment& now) const;

    void end() { state_ = Ended{}; }

  private:
    double length() const { return std::max({thresholds.least_length, tracklet_.size.x, tracklet_.size.y}); }
    void end_before_stay(Tracklet& result) const;
    void record_position(const Moment& now, const PixelBox& box, const glm::dvec2& place, int area);
    void measure(const FrameView& sight, const fields::Planes& scene, const Moment& now);
    void move_to(const glm::dvec2& place, const Moment& now);
    void detect_departure(const Patch& patch, const Plane<std::uint8_t>& field);
    const Moment& steady_since(const Steadiness::Pixel& pixel) const;
    bool is_steady(const Steadiness::Pixel& pixel, const Moment& now) const;
    void restart(const Moment& still, const Moment& now);
    bool is_unchanged(const Patch& before, const Plane<std::uint8_t>& field) const;
    void take_portrait(const FrameView& sight, const Patch& patch, const Moment& now, double worth = 1);

    Origin origin_;
    Size field_;
    State state_;
    Tracklet tracklet_;  ///< so far; `tracklet()` adds what is known at the end only
    Motion motion_;
    Patch patch_;
    Patch pixels_;
    Template template_;
    PixelBox first_box_;       ///< of its first detection
    glm::dvec2 bounds_min_{};  ///< bounds_min_ and bounds_max_: corners of the box around all its places
    glm::dvec2 bounds_max_{};
    int sightings_ = 0;
    int alone_ = 0;                             ///< detections with its own blob
    int continuous_ = 0;                        ///< of these, detections at the last or predicted place
    double peak_area_ = 0;                      ///< of the last seconds: it decays
    std::optional<glm::dvec2> first_velocity_;  ///< nothing until it is known
    Moment moved_again_at_;                     ///< when its last stay ended
    std::optional<Tracklet> departed_;
    Path path_;
    Stays stays_{thresholds.stationary.stay};
    double portrait_due_ = 0;  ///< seconds: time of the next candidate
    double measure_due_ = 0;   ///< seconds: time of the next value of `tracklet_.difference`
};

}  // namespace vvr::tracking
