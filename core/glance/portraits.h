#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/events/event.h"
#include "core/glance/objects.h"
#include "core/glance/trails.h"
#include "core/labels/lettering.h"
#include "core/labels/sheet.h"
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

/// Places stills of the most telling objects in the sheet's band of portraits, with number, deed and time above each,
/// and a line to its place on the trail.
/// \returns the places of the events that have one, from left to right
std::vector<std::size_t> label_portraits(const Objects& objects, const Crops& crops, const Trails& trails,
                                         const labels::Sheet& sheet, const image::Rgba& ink, const image::Rgba& pale,
                                         labels::Lettering& lettering);

/// Writes the number of each object on its trail, where it begins: the most telling ones first, where there is room.
void label_numbers(const Objects& objects, const Trails& trails, const labels::Sheet& sheet,
                   labels::Lettering& lettering);

/// Marks where the longest stays begin and end: a tick across the trail, and the time where there is room.
void label_stays(const Objects& objects, const Trails& trails, const labels::Sheet& sheet,
                 const image::Rgba& background, labels::Lettering& lettering);

}  // namespace vvr::glance
