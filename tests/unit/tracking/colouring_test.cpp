#include "core/tracking/colouring.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace vvr {
namespace {

constexpr double rate = 25;

/// Something of 20 x 40 pixels that goes from one place to another.
tracking::Event walker(double begin, double end, const glm::dvec2& from, const glm::dvec2& to) {
    const auto at = [](double seconds) { return Moment{static_cast<std::int64_t>(seconds * rate), seconds}; };
    const auto box = [](const glm::dvec2& place) {
        const glm::ivec2 p(place);
        return PixelBox{p.x - 10, p.y - 20, p.x + 10, p.y + 20};
    };
    tracking::Event event;
    event.first = at(begin);
    event.last = at(end);
    event.box = bounding_box(box(from), box(to));
    event.path = {{event.first, from}, {event.last, to}};
    event.portrait = tracking::Portrait{event.first, box(from), 1};
    return event;
}

/// Makes the scene 360 x 270 and the clip 100 s, whatever else there is.
std::vector<tracking::Event> within_a_scene(std::vector<tracking::Event> events) {
    events.push_back(walker(0, 0.1, {10, 20}, {10, 20}));
    events.push_back(walker(99.9, 100, {350, 250}, {350, 250}));
    return events;
}

TEST(Colouring, SidesOfACrowdDiffer) {
    std::vector<tracking::Event> crowd;
    for (int k = 0; k < tracking::object_colours; ++k) {
        crowd.push_back(walker(40 + 0.2 * k, 45, {100 + 10 * k, 130}, {130 + 10 * k, 140}));
    }
    const std::vector<int> colours = tracking::colours_of(within_a_scene(crowd));
    EXPECT_EQ(std::set(colours.begin(), colours.begin() + tracking::object_colours).size(), tracking::object_colours);
}

TEST(Colouring, WhatFollowsAtTheSamePlaceDiffers) {
    const std::vector<int> colours = tracking::colours_of(
        within_a_scene({walker(40, 42, {100, 100}, {140, 100}), walker(42.5, 44, {140, 100}, {180, 100}),
                        walker(44.5, 46, {180, 100}, {140, 100})}));
    EXPECT_NE(colours[0], colours[1]);
    EXPECT_NE(colours[1], colours[2]);
    EXPECT_NE(colours[0], colours[2]);
}

TEST(Colouring, FewObjectsHaveAColourEachWhereverTheyAre) {
    std::vector<tracking::Event> few;
    for (int k = 0; k < tracking::object_colours; ++k)
        few.push_back(walker(12 * k, 12 * k + 3, {40 + 40 * k, 100}, {50, 200}));
    const std::vector<int> colours = tracking::colours_of(few);
    EXPECT_EQ(std::set(colours.begin(), colours.end()).size(), tracking::object_colours);
}

TEST(Colouring, GoesByTheFirstFrames) {
    const std::vector<tracking::Event> events{walker(40, 70, {50, 200}, {300, 200}), walker(10, 12, {50, 50}, {60, 50}),
                                              walker(20, 21, {50, 50}, {60, 50})};
    EXPECT_EQ(tracking::colours_of(events), (std::vector{2, 0, 1}));
}

// Objects that are there at once, or of which fewer than four lie between, never have a colour in common where eight
// colours suffice.
TEST(Colouring, NeighboursInTimeDifferWhereverItIsPossible) {
    std::mt19937 random(11);
    const auto upto = [&](double most) { return std::uniform_real_distribution<>(0, most)(random); };
    int shared = 0;
    for (int scene = 0; scene < 200; ++scene) {
        std::vector<tracking::Event> events;
        const int count = 9 + scene % 60;
        const double longest = scene % 3 == 0 ? 60 : 6;
        for (int k = 0; k < count; ++k) {
            const double begin = upto(90);
            events.push_back(walker(begin, begin + upto(longest), {upto(360), upto(270)}, {upto(360), upto(270)}));
        }
        std::ranges::sort(events, {}, [](const tracking::Event& event) { return event.first.seconds; });
        const std::vector<int> colours = tracking::colours_of(events);
        for (std::size_t b = 0; b < events.size(); ++b) {
            const auto at_once = [&](std::size_t a) { return events[a].last.seconds >= events[b].first.seconds; };
            const auto near = [&](std::size_t a) { return at_once(a) || b - a <= 4; };
            std::vector<std::size_t> earlier(b);
            std::iota(earlier.begin(), earlier.end(), std::size_t{0});
            const auto there = std::ranges::count_if(earlier, at_once);
            const auto about = std::ranges::count_if(earlier, near);
            for (std::size_t a = 0; a < b; ++a) {
                if (colours[a] != colours[b]) continue;
                if (there < tracking::object_colours) {
                    EXPECT_FALSE(at_once(a)) << scene << ": " << a << ", " << b;
                }
                if (about < tracking::object_colours) {
                    EXPECT_FALSE(near(a)) << scene << ": " << a << ", " << b;
                }
                shared += near(a);
            }
        }
    }
    EXPECT_GT(shared, 100) << "no scene has more neighbours than colours";
}

TEST(Colouring, IsTheSameEachTimeForADay) {
    std::mt19937 random(3);
    const auto upto = [&](double most) { return std::uniform_real_distribution<>(0, most)(random); };
    std::vector<tracking::Event> day;
    for (int k = 0; k < 10'000; ++k) {
        const double begin = upto(86'000);
        const double length = k % 50 == 0 ? 3000 : 20;
        day.push_back(walker(begin, begin + upto(length), {upto(360), upto(270)}, {upto(360), upto(270)}));
    }
    const std::vector<int> colours = tracking::colours_of(day);
    EXPECT_EQ(colours, tracking::colours_of(day));
    for (int c = 0; c < tracking::object_colours; ++c) EXPECT_GT(std::ranges::count(colours, c), 500) << c;
}

TEST(Colouring, TakesWhatHasNoPathAndNoLength) {
    EXPECT_TRUE(tracking::colours_of({}).empty());
    EXPECT_EQ(tracking::colours_of(std::vector<tracking::Event>(1)), std::vector<int>{0});
    EXPECT_EQ(tracking::colours_of(std::vector<tracking::Event>(3)).size(), 3U);
}

}  // namespace
}  // namespace vvr
