#include <vector>

#include <gtest/gtest.h>

#include "core/events/event.h"

namespace vvr {
namespace {

constexpr Size field{384, 288};
constexpr int most = 384 / 8;

events::Event event_in(const PixelBox& box) {
    events::Event event;
    event.box = box;
    return event;
}

/// `count` small events side by side from a place on.
std::vector<events::Event> small_events(int count, int left, int top, int step) {
    std::vector<events::Event> events;
    for (int k = 0; k < count; ++k) {
        const int x = left + step * (k % 4);
        const int y = top + step * (k / 4);
        events.push_back(event_in({x, y, x + 10, y + 12}));
    }
    return events;
}

void add(std::vector<events::Event>& events, int count, const PixelBox& box) {
    for (int k = 0; k < count; ++k) events.push_back(event_in(box));
}

TEST(Clutter, ADozenInOnePartDominate) {
    std::vector<events::Event> events = small_events(12, 250, 20, 20);
    add(events, 12, {0, 100, 384, 160});
    const auto scraps = events::find_clutter(events, field);
    ASSERT_TRUE(scraps);
    EXPECT_EQ(scraps->count, 12);
    EXPECT_EQ(scraps->box, (PixelBox{250, 20, 320, 72}));
}

TEST(Clutter, FewerThanADozenAreFew) {
    EXPECT_FALSE(events::find_clutter(small_events(11, 250, 20, 20), field));
    EXPECT_FALSE(events::find_clutter({}, field));
}

TEST(Clutter, LessThanHalfOfAllEventsDoNotDominate) {
    std::vector<events::Event> events = small_events(12, 250, 20, 20);
    add(events, 13, {0, 100, 384, 160});
    EXPECT_FALSE(events::find_clutter(events, field));
}

TEST(Clutter, ThoseOfAllPartsOfThePictureAreLeftAlone) {
    // Far people walk everywhere: no region is without them.
    std::vector<events::Event> events;
    for (int k = 0; k < 40; ++k) {
        const int x = 36 * (k % 10);
        const int y = 70 * (k / 10);
        events.push_back(event_in({x, y, x + 10, y + 12}));
    }
    EXPECT_FALSE(events::find_clutter(events, field));
}

TEST(Clutter, WhatGoesFarIsNone) {
    std::vector<events::Event> events;
    add(events, 30, {200, 20, 200 + most, 20 + most});
    EXPECT_TRUE(events::find_clutter(events, field));
    events.clear();
    add(events, 30, {200, 20, 200 + most + 1, 30});
    EXPECT_FALSE(events::find_clutter(events, field));
}

}  // namespace
}  // namespace vvr
