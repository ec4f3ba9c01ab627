#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/annotation/crops.h"
#include "core/annotation/lettering.h"
#include "core/annotation/objects.h"
#include "core/annotation/sheet.h"
#include "core/base/plane.h"
#include "core/tracking/event.h"

namespace vvr::annotation {

/// A point on an object's trail to which its portrait's leader line may go.
struct Anchor {
    glm::dvec2 pixel{};
    double cost = 0;  ///< penalty in pixels, added to the line's length
};

/// A portrait to place.
struct WantedPortrait {
    std::size_t number = 0;  ///< the object's; numbers increase from left to right
    std::vector<Anchor> anchors;
    int wide = 1;  ///< stills side by side
};

/// A portrait placed in the row, with its leader line.
struct PlacedPortrait {
    std::size_t wanted = 0;  ///< index in the list of wanted portraits
    PixelBox still;
    glm::dvec2 from{};  ///< start of the line, at the still's lower edge
    glm::dvec2 to{};
};

/// Places portraits in a row above the trails, by number and as near to their trails as possible. Leader lines
/// never cross: of two that would, the less wanted portrait is dropped for the next one.
/// \param wanted most wanted first; anchors lie below the row
/// \param row area of the stills; its height is their size
/// \param gap minimum distance of stills, in pixels
/// \param obstacles boxes that lines avoid if they can
std::vector<PlacedPortrait> place_portraits(std::span<const WantedPortrait> wanted, const PixelBox& row, int gap,
                                            std::span<const PixelBox> obstacles);

/// Whether the segments a-b and c-d intersect.
bool lines_cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d);

/// An object's portrait in a picture, with its leader line.
struct EventPortrait {
    std::size_t event = 0;  ///< index in the list of events
    const Crop* crop = nullptr;
    const BeforeAndAfter* pair = nullptr;  ///< shown in place of the crop; null = none
    PixelBox still{};
    glm::dvec2 from{};
    glm::dvec2 to{};  ///< on the object's trail
};

/// Places stills of the most important objects in the sheet's portrait band, below the captions. What was left, taken
/// or changed has two side by side, before and after, if `crops` has them.
/// \param numbered indices of the events that may get one
/// \param obstacles boxes that lines avoid if they can
/// \param most_pairs at most this many
/// \returns from left to right
std::vector<EventPortrait> event_portraits(const Objects& objects, const std::set<std::size_t>& numbered,
                                           const Crops& crops, const Trails& trails, const annotation::Sheet& sheet,
                                           std::span<const PixelBox> obstacles, int most_pairs);

/// Draws the portraits, with number, activity and time above each, and a leader line to the object's trail.
/// \param numbered indices of the events that may get one: those that the map or the time strip explains
void label_portraits(const Objects& objects, const std::set<std::size_t>& numbered, const Crops& crops,
                     const Trails& trails, const annotation::Sheet& sheet, const image::Rgba& ink,
                     const image::Rgba& pale, annotation::Lettering& lettering);

}  // namespace vvr::annotation
