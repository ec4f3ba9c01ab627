#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/events/event.h"
#include "core/glance/objects.h"
#include "core/labels/lettering.h"
#include "core/labels/sheet.h"
#include "core/video/frame.h"

namespace vvr::glance {

/// A crop of a frame around an object.
struct Crop {
    Moment at;
    double score = 0;  ///< the portrait's score
    PixelBox object;   ///< bounding box within `picture`
    Plane<Bgr> picture;
};

/// Keeps a crop per track while the fields are read, because frames aren't kept.
class Crops {
  public:
    /// Crops a track's object from a frame and replaces the track's earlier crop.
    /// \param portrait its time must be the frame's
    void keep(std::size_t track, const events::Portrait& portrait, const video::Frame& frame);

    /// The crop of an event: at its portrait's time if kept, else the best of its tracks. Null if none is kept.
    const Crop* find(const events::Event& event) const;

  private:
    // A crop has about 15 kB. A day at a busy gate has thousands of tracks; a picture has room for about ten.
    static constexpr std::size_t max_crops = 1024;

    std::map<std::size_t, Crop> crops_;
};

/// A square still per event, for lists: smaller if there are many events, empty if an event has no crop.
std::vector<Plane<Bgr>> portraits_of(std::span<const events::Event> events, const Crops& crops);

/// The square part of a frame that a still of an object shows: the object with some of its surroundings.
PixelBox still_box(const PixelBox& object, Size frame);

/// A point on an object's trail to which its portrait's leader line may go.
struct Anchor {
    glm::dvec2 pixel{};
    double cost = 0;  ///< penalty in pixels, added to the line's length
};

/// A portrait to place.
struct WantedPortrait {
    double seconds = 0;  ///< time of the clip that orders the portraits
    std::vector<Anchor> anchors;
};

/// A portrait placed in the row, with its leader line.
struct PlacedPortrait {
    std::size_t wanted = 0;  ///< index in the list of wanted portraits
    PixelBox still;
    glm::dvec2 from{};  ///< start of the line, at the still's lower edge
    glm::dvec2 to{};
};

/// Places portraits in a row above the trails, in time order and as near to their trails as possible. Leader lines
/// never cross: of two that would, the less wanted portrait is dropped for the next one.
/// \param wanted most wanted first; anchors lie below the row
/// \param row area of the stills; its height is their size
/// \param gap minimum distance of stills, in pixels
/// \param obstacles boxes that lines avoid if they can
std::vector<PlacedPortrait> place_portraits(std::span<const WantedPortrait> wanted, const PixelBox& row, int gap,
                                            std::span<const PixelBox> obstacles);

/// Whether the segments a-b and c-d intersect.
bool lines_cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d);

/// Places stills of the most important objects in the sheet's portrait band, with number, activity and time above each,
/// and a leader line to the object's trail.
/// \returns the indices of the events shown, from left to right
std::vector<std::size_t> label_portraits(const Objects& objects, const Crops& crops, const Trails& trails,
                                         const labels::Sheet& sheet, const image::Rgba& ink, const image::Rgba& pale,
                                         labels::Lettering& lettering);

}  // namespace vvr::glance
