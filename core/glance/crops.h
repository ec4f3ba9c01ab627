#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/events/event.h"
#include "core/video/frame.h"

namespace vvr::glance {

/// A part of a frame around an object.
struct Crop {
    Moment at;
    double score = 0;  ///< of the portrait
    PixelBox object;   ///< within the picture
    Plane<Bgr> picture;
};

/// Keeps a still of each track while the fields are read: afterwards its frame is gone.
class Crops {
  public:
    /// Takes the crop of a track in this frame, in place of an earlier one.
    /// \param portrait whose moment is that of the frame
    void keep(std::size_t track, const events::Portrait& portrait, const video::Frame& frame);

    /// The still of an event, at its portrait's moment where that is there, else the best one of its tracks.
    const Crop* of(const events::Event& event) const;

  private:
    // About 15 kB each: a day at a busy gate has thousands of tracks, and a picture has room for some ten.
    static constexpr std::size_t most = 1024;

    std::map<std::size_t, Crop> crops_;
};

/// A still of each event for a list of them; smaller where there are very many, empty where there is none.
std::vector<Plane<Bgr>> portraits_of(std::span<const events::Event> events, const Crops& crops);

/// The square around an object that a still shows: with some of the scene around it, within the frame.
PixelBox still_box(const PixelBox& object, Size frame);

}  // namespace vvr::glance
