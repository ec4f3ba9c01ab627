#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "core/events/appearance.h"
#include "core/events/event_options.h"
#include "core/events/patch.h"
#include "core/events/path.h"
#include "core/events/pixel_history.h"
#include "core/events/tracklet.h"

namespace vvr::events {

/// What is going on with a track; docs/report.md has the diagram.
enum class State {
    moving,    ///< it has a blob of its own
    merged,    ///< it shares a blob with others
    unseen,    ///< no blob is where it should be
    standing,  ///< its pixels have kept their values: it is known by them, whoever stands about it
    appeared,  ///< the same, and it has only been seen to stand: nobody saw it come
    over,      ///< it has ended
};

/// Where a track is in its way across the border of the picture.
enum class Crossing {
    entering,  ///< it was never clear of the border
    inside,    ///< it is clear of it
    leaving,   ///< it was, and touches it
};

/// Out of whom a track came.
struct Origin {
    std::optional<std::size_t> track{};  ///< its number
    double area = 0;                     ///< what was usual of the blob that it left, pixels
    bool was_alone = false;              ///< in that blob
};

/// An object that is being followed from field to field.
class Track {
  public:
    Track(std::size_t number, const Origin& origin, Size field) : number_(number), origin_(origin), field_(field) {}

    std::size_t number() const { return number_; }
    std::optional<std::size_t> from() const { return origin_.track; }
    State state() const { return state_; }
    bool stands() const { return state_ == State::standing || state_ == State::appeared; }
    bool is_over() const { return state_ == State::over; }
    bool follows_blobs() const { return !stands() && !is_over(); }

    /// As it was when it was last seen alone, where it is now.
    const Patch& patch() const { return patch_; }
    /// Its pixels in the last field in which it was seen.
    const Patch& pixels() const { return pixels_; }
    const Appearance& look() const { return look_; }
    const std::optional<Portrait>& portrait() const { return portrait_; }
    const Moment& first() const { return first_; }
    const Moment& seen() const { return seen_; }
    glm::dvec2 usual_size() const { return usual_size_; }
    double usual_area() const { return usual_area_; }
    /// The same of who is coming in, and has been larger of late than usual.
    double current_area() const { return std::max<double>(usual_area_, template_.patch.area); }
    std::optional<std::size_t> near() const { return near_; }

    /// Whether it has been seen for long enough to be more than a piece of something.
    bool is_confirmed() const { return seen_.seconds - first_.seconds >= thresholds.event.least; }

    /// Whether motion has led its middle out of the picture.
    bool is_outside() const {
        return patch_.centre.x < 0 || patch_.centre.y < 0 || patch_.centre.x >= field_.width ||
               patch_.centre.y >= field_.height;
    }

    /// Whether it began at the border of the picture, out of nobody.
    bool entered_at_border() const { return !origin_.track && begin_.at_border; }

    /// Where it will be, as a shift of its patch: whole pixels.
    glm::ivec2 shift_at(const Moment& now) const;

    /// The same as a shift of what it looked like when it was last alone.
    glm::ivec2 template_shift_at(const Moment& now) const;
    const Template& appearance_template() const { return template_; }

    /// Who is in front of it, or about it.
    void set_near(std::optional<std::size_t> number) { near_ = number; }

    /// Whether it has all but left the picture.
    bool is_leaving() const {
        return crossing_ == Crossing::leaving && least_at_border_ < thresholds.track.leaving_share * usual_area_;
    }

    /// Whether it is leaving, and this blob is somebody else who comes in at the same place.
    bool is_replaced_by(const Patch& blob) const;

    /// It is this blob now.
    void see(const Patch& patch, const Appearance& look, const FrameView& sight, const Flicker& flicker,
             const Moment& now);

    /// It is this part of a blob that several objects share.
    /// \param has_room the blob is as large as they are together, so that nobody hides another
    /// \returns whether there is enough of it to be sure
    bool update_merged(const TemplateMatch& share, const Patch& blob, bool has_room, const FrameView& sight,
                       const Moment& now);

    /// It is somewhere in a blob that it shares, and nobody can tell where.
    void miss_merged(const Moment& now) {
        state_ = State::merged;
        miss(now);
    }

    /// It is not to be seen, and may go on as before.
    void miss(const Moment& now);

    /// Whether it has stood still for long enough, by its pixels.
    bool has_settled(const Steadiness& steadiness, const Flicker& flicker, const Moment& now) const;

    /// From now on it stands: it is those of its pixels that have kept their values.
    /// If it came out of another, as a bag does, it began when it became still.
    void settle(const Steadiness& steadiness, const FrameView& sight, const Moment& now);

    /// Both stand: whether they are parts of one thing, which came to rest side by side within `stationary.stay`.
    bool belongs_to(const Track& other) const;

    /// It stands, and so does this part of it.
    void add_part(const Track& part, const FrameView& sight);

    /// Of an object that stands, the part of its pixels that are seen.
    double visible_part(const Plane<std::uint8_t>& field) const;

    /// It stands, and is seen, now. `alone` where nobody is in front of it or beside it.
    void update_stationary(const FrameView& sight, const Moment& now, bool alone);

    /// It stands no more, for it moves.
    void resume_motion(const Moment& now);

    /// It began in pieces, of which this is one.
    void join(const Track& piece);

    /// Ends the track.
    Tracklet finish(std::optional<std::size_t> into, const Moment& now);

    /// Ends it without a trace: it was a piece of another.
    void drop() { state_ = State::over; }

  private:
    void record_position(const Moment& now, const PixelBox& box, const glm::dvec2& place, int area);
    glm::dvec2 expected_at(const Moment& now) const { return place_ + velocity_ * (now.seconds - place_at_.seconds); }
    void move_to(const glm::dvec2& place, const Moment& now);
    PixelBox moved_box_at(const Moment& now) const;
    bool is_steady(const Steadiness::Pixel& pixel, const Moment& now) const;
    void take_portrait(const FrameView& sight, const Patch& patch, const Moment& now, double worth = 1);
    bool touches_border(const PixelBox& box) const;

    std::size_t number_;
    Origin origin_;
    Size field_;
    State state_ = State::moving;
    std::optional<std::size_t> near_;

    Patch patch_;
    Patch pixels_;
    Template template_;
    Appearance look_;
    Moment first_;
    Moment seen_;
    PixelBox box_;
    glm::dvec2 low_{};  ///< corners of the box about all its places
    glm::dvec2 high_{};
    int sightings_ = 0;
    int alone_ = 0;       ///< sightings with a blob of its own
    int continuous_ = 0;  ///< of which it was where it was before, or where motion leads
    double flicker_sum_ = 0;
    int flicker_count_ = 0;
    glm::dvec2 usual_size_{};  ///< of its box of late
    double usual_area_ = 0;
    Crossing crossing_ = Crossing::entering;
    double least_at_border_ = 0;  ///< its least area while it has been leaving
    glm::dvec2 place_{};          ///< where its middle is, also while it is not seen
    Moment place_at_;             ///< when it was there
    glm::dvec2 velocity_{};       ///< field pixels per second
    std::deque<PathPoint> recent_;
    TrackEnd begin_;
    std::optional<glm::dvec2> first_velocity_;  ///< once it is known
    std::optional<Settled> settled_;
    Stay stay_;
    Moment risen_;       ///< when it last rose
    Moment last_whole_;  ///< when it was last seen to stand with nobody in front of it
    Path path_;
    Stays stays_{thresholds.stationary.stay};
    std::optional<Portrait> portrait_;
    double portrait_due_ = 0;  ///< seconds: when to look for a better one
};

}  // namespace vvr::events
