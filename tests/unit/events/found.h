#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "core/events/event_finder.h"
#include "tests/scene/scene.h"

// What is found in generated scenes.
namespace vvr::test {

struct Found {
    generator::Scene scene;
    events::Findings all;
    std::vector<events::FrameLabels> labels;
};

/// Prints events, changes and overlays.
std::ostream& operator<<(std::ostream& out, const Found& found);

/// Options of a picture of 192x144.
generator::Options small(std::uint64_t seed = 1, double noise = 0);

Found found_in(generator::Scene scene, const std::string& reference = "median");

std::vector<events::EventKind> kinds_of(const std::vector<events::Event>& events);

/// The mean distance of an event from an object of the scene, pixels; infinite if they are never there together.
double distance_to(const events::Event& event, const generator::Scene& scene, const std::string& name);

/// The first and the last frame in which enough of an object can be seen.
struct Visible {
    int first = -1;
    int last = -1;
};
Visible visible(const generator::Scene& scene, const std::string& name);

}  // namespace vvr::test
