#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/scene/canvas.h"
#include "tests/scene/figure.h"
#include "tests/scene/happenings.h"

// What the small scenes are made of: people who walk and stand, and boxes.
namespace vvr::generator {

// Scenes are described for a picture of this size; a larger one is the same, enlarged.
inline constexpr double story_height = 144;
inline constexpr double story_width = 192;
inline constexpr double person = 48;  ///< height, story pixels

/// Pixels per story pixel.
double scale_of(const Options& options);

/// A place at a frame, story pixels; nothing while nobody is there.
using Way = std::function<std::optional<Point>(double frame)>;

/// From one side of the picture to the other, with `speed` story pixels per frame; negative = to the left.
Way across(double enters, double speed, double floor);

/// To a place, where it stops from `arrives` to `leaves`, and on.
Way with_stop(double place, double arrives, double leaves, double speed, double floor);

/// An irregular motion between -1 and 1 whose slowest part has that period in frames.
double wander(double frame, double period, std::uint64_t seed);

/// Something that is drawn: by its name, and as a function of the frame on a canvas.
struct Actor {
    std::string name;
    Way middle;
    std::function<void(Canvas& canvas, double frame)> paint;
};

/// Somebody's way, looks and habits.
struct Person {
    Way feet;
    std::uint64_t seed = 1;
    double bow_at = -1;  ///< frame; negative = never
    double sway = 0;     ///< radians by which the body leans while it stands, at most
};

/// How somebody is painted at a frame, in pixels.
/// \pre they are there
Figure figure_of(const Options& options, const Person& who, double frame);

Actor walker(std::string name, const Options& options, Person who);

/// A box at a place, with `stripes` stripes of its colour.
Actor box(std::string name, const Options& options, Way middle, Point half, Colour colour, int stripes = 0);

/// A way of something that keeps its place.
Way at_place(Point place, Interval there);

Scene make_happening(Options options, int frames, std::vector<Actor> actors);

}  // namespace vvr::generator
