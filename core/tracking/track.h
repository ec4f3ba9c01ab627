#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>

#include "core/tracking/appearance.h"
#include "core/tracking/claim.h"
#include "core/tracking/event_options.h"
#include "core/tracking/patch.h"
#include "core/tracking/path.h"
#include "core/tracking/pixel_history.h"
#include "core/tracking/tracklet.h"

namespace vvr::tracking {

/// The state of a track; docs/report.md has the diagram.
enum class State {
    moving,    ///< it has its own blob
    merged,    ///< it shares a blob with others
    unseen,    ///< no blob is at its predicted place
    standing,  ///< stationary: its steady pixels identify it, whoever stands near
    appeared,  ///< stationary, and never seen to move: nobody saw it come
    over,      ///< it has ended
};

/// The track from which another one split.
struct Origin {
    std::optional<std::size_t> track{};  ///< number of the parent track
    double area = 0;                     ///< usual area of the parent, field pixels
    bool was_alone = false;              ///< whether the parent had its own blob
};

/// An object that is tracked from field to field.
class Track {
  public:
    Track(std::size_t number, const Origin& origin, Size field) : number_(number), origin_(origin), field_(field) {}

    std::size_t number() const { return number_; }
    std::optional<std::size_t> from() const { return origin_.track; }
    State state() const { return state_; }
    bool stands() const { return state_ == State::standing || state_ == State::appeared; }
    bool is_over() const { return state_ == State::over; }
    bool follows_blobs() const { return !stands() && !is_over(); }

    /// Its pixels when it was last alone, shifted to its current place.
    const Patch& patch() const { return patch_; }
    /// Its pixels in the last field in which it was seen.
    const Patch& pixels() const { return pixels_; }
    const Appearance& look() const { return look_; }
    const std::optional<Portrait>& portrait() const { return portrait_; }
    const Moment& first() const { return first_; }
    const Moment& seen() const { return seen_; }
    glm::dvec2 usual_size() const { return usual_size_; }
    double usual_area() const { return usual_area_; }
    /// The usual area, or the last area alone if that is larger, as it is for an object that enters.
    double current_area() const { return std::max<double>(usual_area_, template_.patch.area); }
    std::optional<std::size_t> near() const { return near_; }

    /// Whether it has been seen for so long that it is no fragment or noise.
    bool is_confirmed() const { return seen_.seconds - first_.seconds >= thresholds.event.least; }

    /// Since when it moves, or stands no longer than what is seen counts, seconds. None if it can't become an event
    /// yet: noise and leaves stay where they are.
    std::optional<double> busy_since(const Moment& now) const {
        if (is_over() || !is_confirmed()) return {};
        const double length = std::max({thresholds.least_length, usual_size_.x, usual_size_.y});
        const bool goes = 2 * glm::distance(low_, high_) >= thresholds.event.own_lengths * length;
        const bool rests = stands() && now.seconds - settled_->since.seconds > thresholds.memory;
        if (rests || !(goes || settled_)) return {};
        return std::max(first_.seconds, risen_.seconds);
    }

    /// Whether its predicted centre is outside of the picture.
    bool is_outside() const {
        return patch_.centre.x < 0 || patch_.centre.y < 0 || patch_.centre.x >= field_.width ||
               patch_.centre.y >= field_.height;
    }

    /// Whether it began at the border of the picture and split from no other.
    bool entered_at_border() const { return !origin_.track && begin_.at_border; }

    /// The shift of `patch` to the predicted place, whole pixels.
    glm::ivec2 shift_at(const Moment& now) const;

    /// The shift of the template to the predicted place, whole pixels.
    glm::ivec2 template_shift_at(const Moment& now) const;
    const Template& appearance_template() const { return template_; }

    /// Sets the track that occludes it or is near it.
    void set_near(std::optional<std::size_t> number) { near_ = number; }

    /// Continues the track with a blob of its own.
    void see(const Patch& patch, const Appearance& look, const FrameView& sight, const Moment& now);

    /// Compares the looks of its box with those of the same box in the empty scene.
    /// \param scene may be empty
    void look_for_novelty(const FrameView& sight, const fields::Planes& scene, const Moment& now);

    /// Continues the track with its part of a shared blob.
    /// \returns whether the match is certain enough
    bool update_merged(const TemplateMatch& share, const Patch& blob, const FrameView& sight, const Moment& now);

    /// Continues the track in a shared blob at an unknown place.
    void miss_merged(const Moment& now) {
        state_ = State::merged;
        miss(now);
    }

    /// Continues the track without a detection, at its predicted place.
    void miss(const Moment& now);

    /// The track as it was when it left the picture, if what has been seen since is what it left behind: less than half
    /// of it, that came off the border in a blob of its own and has not been back. Null if it did not leave.
    std::shared_ptr<const Track> departed() const { return departed_; }

    /// Whether enough of its pixels have been steady for long enough.
    bool has_settled(const Steadiness& steadiness, const Flicker& flicker, const Moment& now) const;

    /// Makes the object stationary: from now on it consists of its steady pixels. If it split from another object, as a
    /// bag does, it begins when it became still.
    void settle(const Steadiness& steadiness, const Flicker& flicker, const FrameView& sight, const Moment& now);

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
    void update_stationary(const FrameView& sight, const Moment& now, bool whole, bool beside);

    /// Continues a stationary object that is occluded.
    void miss_stationary() { alone_at_.reset(); }

    /// When less than half of its place first differed from the empty scene since it was last seen.
    const std::optional<Moment>& uncovered() const { return uncovered_; }
    void set_uncovered(std::optional<Moment> since) { uncovered_ = since; }

    /// When it became still. Only for a stationary object.
    const Moment& still_since() const { return settled_->since; }

    /// Records the share of the picture that differed from the empty scene when it became still.
    void set_changed(double share) { settled_->evidence.changed = share; }

    /// Ends the stationary state: the object moves.
    void resume_motion(const Moment& now);

    /// Adds a fragment with which the object began.
    void join(const Track& piece);

    /// Ends the track.
    /// \param into number of the track in which it merged
    /// \param scene the empty scene; may be empty
    Tracklet finish(std::optional<std::size_t> into, const fields::Planes& scene, const Moment& now);

    /// Ends the track without a tracklet: it was a fragment of another.
    void drop() { state_ = State::over; }

  private:
    void record_position(const Moment& now, const PixelBox& box, const glm::dvec2& place, int area);
    glm::dvec2 expected_at(const Moment& now) const { return place_ + velocity_ * (now.seconds - place_at_.seconds); }
    void move_to(const glm::dvec2& place, const Moment& now);
    void look_for_departure(const Patch& patch, const Plane<std::uint8_t>& field);
    PixelBox moved_box_at(const Moment& now) const;
    bool is_steady(const Steadiness::Pixel& pixel, const Moment& now) const;
    void begin_again(const Moment& still, const Moment& now);
    bool is_unchanged(const Patch& before, const Plane<std::uint8_t>& field) const;
    void take_portrait(const FrameView& sight, const Patch& patch, const Moment& now, double worth = 1);

    std::size_t number_;
    Origin origin_;
    Size field_;
    State state_ = State::moving;
    State stood_as_ = State::standing;  ///< before it last moved again
    std::optional<std::size_t> near_;

    Patch patch_;
    Patch pixels_;
    Template template_;
    Appearance look_;
    Moment first_;
    Moment seen_;
    PixelBox box_;
    PixelBox first_box_;  ///< of its first detection
    glm::dvec2 low_{};    ///< low_ and high_: corners of the box around all its places
    glm::dvec2 high_{};
    int sightings_ = 0;
    int alone_ = 0;            ///< detections with its own blob
    int continuous_ = 0;       ///< of these, detections at the last or predicted place
    glm::dvec2 usual_size_{};  ///< running mean of the box's width and height, field pixels
    double usual_area_ = 0;
    double peak_area_ = 0;   ///< of the last seconds: it decays
    glm::dvec2 place_{};     ///< current centre, also while it is unseen
    Moment place_at_;        ///< time of `place_`
    glm::dvec2 velocity_{};  ///< field pixels per second
    std::deque<PathPoint> recent_;
    TrackEnd begin_;
    std::optional<glm::dvec2> first_velocity_;  ///< nothing until it is known
    std::optional<Settled> settled_;
    Stay stay_;
    Moment risen_;       ///< when it last moved again
    Moment last_whole_;  ///< when it was last stationary and not occluded
    StillPicture still_;
    std::optional<Moment> alone_at_;  ///< now, while it is in view and nobody is near
    std::optional<Moment> uncovered_;
    std::shared_ptr<const Track> departed_;
    Path path_;
    Stays stays_{thresholds.stationary.stay};
    std::optional<Portrait> portrait_;
    double portrait_due_ = 0;  ///< seconds: time of the next candidate
    double novelty_ = 0;       ///< mean of `novelties_` values
    int novelties_ = 0;
    double novelty_due_ = 0;  ///< seconds: time of the next value
};

}  // namespace vvr::tracking
