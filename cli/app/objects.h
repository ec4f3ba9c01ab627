#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/bricks/owners.h"
#include "core/bricks/volume.h"
#include "core/events/colouring.h"
#include "core/events/event.h"
#include "core/events/patch.h"

// What is told of objects, and whose the voxels of a volume are.
namespace vvr::app {

/// The events that a picture, a page and a report tell of.
struct ToldEvents {
    std::vector<events::Event> events;
    std::vector<std::size_t> numbers;  ///< by which people know them
    std::vector<int> colours;          ///< as `colours_of` gives them
};

/// Those of a clip that were there at some time from `begin` to `end`, with the part of their paths that lies in it.
/// Their numbers are their places among all, plus 1.
ToldEvents told_in(std::span<const events::Event> events, double begin, double end);

/// Of a clip that has ended: an object's colour and number are those of its event.
bricks::Identify objects_of(std::span<const events::Event> events, const bricks::Volume& volume);

/// Of a clip that goes on. Which tracks are one object isn't known yet: each has a colour of its own, of those in sight
/// the one that was not seen for longest. What was seen for less than an event lasts is nobody's until it is known to
/// be more. What was decided for a stretch of the clip stays: consecutive pictures show it alike.
class LiveObjects {
  public:
    void see(const events::FrameLabels& labels);

    /// A stretch of the clip has ended, and is drawn next.
    /// \param oldest frame that will be drawn from now on
    void decide(std::int64_t oldest);

    /// The colour of a track that has been seen of late, 0 to `object_colours` - 1.
    std::optional<int> colour_of(std::size_t track) const;

    /// The number of the event that a track belongs to, from now on; what was drawn before keeps its own.
    void give_number(std::size_t track, std::size_t number) { numbers_[track] = number; }

    /// \returns what asks this object, which outlives it
    bricks::Identify identify() const;

  private:
    struct Seen {
        Moment first;
        Moment last;
        int colour = 0;
        std::int64_t undecided = 0;  ///< from this frame on, unless it is decided
        bool decided = false;
    };

    int next_colour() const;

    std::map<std::size_t, Seen> tracks_;
    std::map<std::size_t, std::size_t> numbers_;
    std::array<std::int64_t, events::object_colours> last_seen_{};  ///< 1 + frame; of each colour
    Moment last_;
};

}  // namespace vvr::app
