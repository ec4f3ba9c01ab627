#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "core/events/patch.h"
#include "core/events/path.h"
#include "core/events/stays.h"
#include "core/events/steadiness.h"

namespace vvr {

/// An object that is being followed from field to field.
///
/// It moves, or it stands: then its pixels have kept their values for so long that they are known, and it is there as
/// long as some of them are seen, whoever stands about it.
class Track {
  public:
    Track(std::size_t number, const Patch& patch, const Moment& now, const EventOptions& options);

    std::size_t number() const { return number_; }
    bool stands() const { return stands_; }
    bool was_merged() const { return merged_; }
    const Patch& patch() const { return patch_; }
    const Moment& first() const { return first_; }
    const Moment& seen() const { return seen_; }

    /// Whether it has been seen for long enough to be more than a piece of something.
    bool is_certain() const;

    /// Whether it is one: it stood still, or it has gone farther than it is long, which a flag in the wind does not.
    bool is_event() const;

    /// Where it will be, as a shift of its patch: whole pixels.
    glm::ivec2 step() const { return glm::ivec2(glm::round(velocity_)); }

    /// It is this patch now.
    void see(const Patch& patch, const Moment& now);

    /// It is somewhere within a larger object. Looks for what it was, near where it should be by now.
    /// \returns whether there is something like it
    bool see_within(const Plane<std::uint8_t>& field, const Moment& now);

    /// It is not to be seen, and may go on as before.
    void miss();

    /// Whether it has stood still for long enough, by its pixels.
    bool has_settled(const Steadiness& steadiness, const Moment& now) const;

    /// From now on it stands: it is those of its pixels that have kept their values.
    /// \param out_of_another whether it came out of another object: then it began when it became still
    void settle(const Steadiness& steadiness, const Moment& now, bool out_of_another);

    /// Both stand: whether they are parts of one thing, which came to rest side by side within `options.stay`.
    bool belongs_to(const Track& other, int reach) const;

    /// It stands, and so does this part of it.
    void add_part(const Track& part);

    /// Of an object that stands, the part of its pixels that are seen.
    double visible_part(const Plane<std::uint8_t>& field) const;

    /// It stands, and is seen, now.
    void see_standing(const Moment& now);

    /// It stands no more, for it moves.
    void rise();

    /// It began in pieces, of which this is one.
    void join(const Track& piece);

    Event finish();

  private:
    void went_on(const Moment& now, const PixelBox& box, const glm::dvec2& place);
    void end_stay();

    std::size_t number_;
    EventOptions options_;
    Patch patch_;  ///< as it was when it was last seen alone, where it is now
    Moment first_;
    Moment seen_;
    PixelBox box_;
    glm::dvec2 low_{};  ///< corners of the box about all its places
    glm::dvec2 high_{};
    double sides_ = 0;  ///< of its boxes, the longer one, added up
    int sightings_ = 0;
    bool settled_ = false;   ///< whether it ever stood
    glm::dvec2 velocity_{};  ///< field pixels a frame
    glm::dvec2 shift_{};     ///< by which a patch within a larger object is off whole pixels
    std::deque<glm::dvec2> recent_;
    bool merged_ = false;
    bool stands_ = false;
    Moment still_since_;  ///< by its pixels, which may be before it was first told from what it was part of
    Stay stay_;
    Path path_;
    Stays stays_;
};

}  // namespace vvr
