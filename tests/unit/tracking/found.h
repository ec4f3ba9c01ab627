#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/tracking/event_finder.h"
#include "tests/scene/happenings.h"

// What is found in generated scenes.
namespace vvr::test {

/// The moment of a frame at 25 frames per second.
inline Moment at(std::int64_t frame) {
    return {frame, static_cast<double>(frame) / 25};
}

struct Found {
    generator::Scene scene;
    tracking::Findings all;
    std::vector<tracking::FrameLabels> labels;
};

/// Prints events, changes and overlays.
std::ostream& operator<<(std::ostream& out, const Found& found);

/// Options of a picture of 192x144.
generator::Options small(std::uint64_t seed = 1, double noise = 0);

Found found_in(generator::Scene scene, const std::string& reference = "median");

std::vector<tracking::EventKind> kinds_of(const std::vector<tracking::Event>& events);

/// The mean distance of an event from an object of the scene, pixels; infinite if they are never there together.
double distance_to(const tracking::Event& event, const generator::Scene& scene, const std::string& name);

/// The first and the last frame in which enough of an object can be seen.
generator::Interval visible(const generator::Scene& scene, const std::string& name);

constexpr double half_a_second = 12.5;  // frames

/// Expects an event or a stay that is there from the first to the last frame, more or less.
template <class Part>
void expect_frames(const Part& part, const generator::Interval& expected, double most = half_a_second) {
    EXPECT_NEAR(static_cast<double>(part.first.frame), expected.first, most);
    EXPECT_NEAR(static_cast<double>(part.last.frame), expected.last, most);
}

}  // namespace vvr::test
