#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/tracking/colouring.h"
#include "core/tracking/event.h"
#include "core/tracking/patch.h"
#include "core/volume/owners.h"
#include "core/volume/volume.h"

// The events that outputs show, and the mapping from voxels to objects.
namespace vvr::app {

/// The events that a picture, a page and a report show.
struct ShownEvents {
    std::vector<tracking::Event> events;
    std::vector<std::size_t> numbers;  ///< the numbers shown to people
    std::vector<int> colours;          ///< from `colours_of`
};

/// The events of a clip that overlap the time from `begin` to `end`, cut to that time. An event's number is its index
/// among all events plus 1.
ShownEvents events_between(std::span<const tracking::Event> events, double begin, double end);

/// For a clip that has ended: an object has the colour and number of its event.
volume::VoxelStyleLookup objects_of(std::span<const tracking::Event> events, const volume::Volume& volume);

/// For a live stream, where it isn't known yet which tracks are the same object. Each track gets its own colour: the
/// one that has been unused for longest. A track shorter than an event belongs to no object until it is longer.
/// Decisions about a stretch of the clip are final, so consecutive pictures show it alike.
class LiveObjects {
  public:
    void see(const tracking::FrameLabels& labels);

    /// Decides about a stretch of the clip that has ended and is drawn next.
    /// \param oldest first frame that later pictures can show
    void decide(std::int64_t oldest);

    /// The colour of a recent track, 0 to `object_colours` - 1.
    std::optional<int> colour_of(std::size_t track) const;

    /// Sets the number of the event to which a track belongs. Stretches already decided keep theirs.
    void give_number(std::size_t track, std::size_t number) { numbers_[track] = number; }

    /// \returns a function that refers to this object and must not outlive it
    volume::VoxelStyleLookup identify() const;

  private:
    struct Seen {
        Moment first;
        Moment last;
        int colour = 0;
        std::int64_t undecided = 0;  ///< first undecided frame
        bool decided = false;
    };

    int next_colour() const;

    std::map<std::size_t, Seen> tracks_;
    std::map<std::size_t, std::size_t> numbers_;
    std::array<std::int64_t, tracking::object_colours> last_seen_{};  ///< 1 + frame, per colour
    Moment last_;
};

/// Where a track was seen in one frame.
struct TrackBox {
    std::int64_t frame = 0;
    std::size_t track = 0;
    PixelBox box;  ///< field pixels
};

/// Adds the boxes of a frame's tracks, each around all pixels of the track.
void add_boxes(const tracking::FrameLabels& labels, std::vector<TrackBox>& boxes);

}  // namespace vvr::app
