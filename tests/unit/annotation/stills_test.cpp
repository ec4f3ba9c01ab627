// The frames that tell most of the events.
#include "core/annotation/stills.h"

#include <vector>

#include <gtest/gtest.h>

namespace vvr {
namespace {

constexpr Size frame_size{160, 120};

annotation::Still still_at(std::int64_t frame, std::vector<annotation::ObjectInStill> objects) {
    return {frame, static_cast<double>(frame), Plane<Bgr>({320, 240}), std::move(objects)};
}

tracking::Event event_of(std::size_t track, std::int64_t first, std::int64_t last) {
    tracking::Event event;
    event.first = {first, static_cast<double>(first)};
    event.last = {last, static_cast<double>(last)};
    event.tracks = {track};
    return event;
}

TEST(ChosenStills, ShowEachEventWhereItIsLargest) {
    const std::vector<tracking::Event> events{event_of(0, 0, 40), event_of(3, 100, 140)};
    std::vector<annotation::Still> stills;
    for (int k = 0; k <= 140; k += 2) {
        std::vector<annotation::ObjectInStill> objects;
        if (k <= 40) objects.push_back({0, {40, 20, 50 + k, 30 + k}});     // it comes closer
        if (k >= 100) objects.push_back({3, {60, 10, 210 - k, 160 - k}});  // it goes away
        if (k % 4 == 0) objects.push_back({1, {0, 0, 150, 110}});          // of no event
        stills.push_back(still_at(k, objects));
    }
    const auto shown = annotation::choose_stills(stills, events, frame_size, 4.0 / 3, 2);
    ASSERT_EQ(shown.size(), 2U);
    EXPECT_EQ(shown[0].still->frame, 40);
    EXPECT_EQ(shown[1].still->frame, 100);
    for (std::size_t k = 0; k < 2; ++k) {
        ASSERT_EQ(shown[k].marked.size(), 1U);
        EXPECT_EQ(shown[k].marked.front().track, k) << "the event's index";
    }
}

TEST(ChosenStills, ShowAPartOfTheFrameWhereObjectsAreSmall) {
    const std::vector<tracking::Event> events{event_of(0, 0, 9)};
    const auto part = [&](const PixelBox& box) {
        const std::vector<annotation::Still> stills{still_at(5, {{0, box}})};
        const auto shown = annotation::choose_stills(stills, events, frame_size, 4.0 / 3, 3);
        EXPECT_EQ(shown.size(), 1U);
        EXPECT_EQ(intersection(shown.at(0).part, box), box) << "all of it";
        return shown.at(0).part;
    };
    EXPECT_EQ(part({100, 80, 106, 92}).size(), (Size{64, 48})) << "four times its size";
    EXPECT_EQ(part({40, 20, 70, 100}), (PixelBox{0, 0, 160, 120}));
}

TEST(ChosenStills, LeaveNoLongTimeOut) {
    const std::vector<tracking::Event> events{event_of(0, 0, 10)};
    std::vector<annotation::Still> stills;
    for (int k = 0; k <= 100; k += 2) {
        stills.push_back(still_at(k, {}));
        if (k <= 10) stills.back().objects.push_back({0, {40, 20, 50, 30}});
        if (k >= 60 && k <= 68) stills.back().objects.push_back({7, {0, 0, 50 + k, 50}});  // of no event
    }
    const auto shown = annotation::choose_stills(stills, events, frame_size, 4.0 / 3, 5);
    ASSERT_EQ(shown.size(), 2U) << "one of the event is enough, and then nothing changes";
    EXPECT_LE(shown[0].still->frame, 10);
    EXPECT_GE(shown[1].still->frame, 60);
    EXPECT_LE(shown[1].still->frame, 68);
    EXPECT_EQ(shown[1].part, (PixelBox{0, 0, 160, 120})) << "all of it, as nobody knows what it is";
}

TEST(ChosenStills, AreNoneWithoutEvents) {
    const std::vector<annotation::Still> stills{still_at(5, {{0, {1, 2, 30, 40}}})};
    EXPECT_TRUE(annotation::choose_stills(stills, {}, frame_size, 4.0 / 3, 3).empty());
    EXPECT_TRUE(annotation::choose_stills({}, std::vector{event_of(0, 0, 9)}, frame_size, 4.0 / 3, 3).empty());
}

}  // namespace
}  // namespace vvr
