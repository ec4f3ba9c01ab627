#include <gtest/gtest.h>

#include "core/glance/portraits.h"

namespace vvr {
namespace {

/// Each pixel says where it is.
video::Frame frame_of(std::int64_t index, Size size) {
    video::Frame frame{index, static_cast<double>(index), Plane<std::uint8_t>(size), Plane<Bgr>(size)};
    for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i) {
            frame.colour.at(i, j) = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j),
                                     static_cast<std::uint8_t>(index)};
        }
    }
    return frame;
}

events::Event event_of(std::vector<std::size_t> tracks) {
    events::Event event;
    event.tracks = std::move(tracks);
    return event;
}

TEST(StillBox, IsASquareAroundTheObjectWithinTheFrame) {
    EXPECT_EQ(glance::still_box({100, 90, 120, 130}, {200, 200}), PixelBox(80, 80, 140, 140));
    EXPECT_EQ(glance::still_box({0, 0, 10, 60}, {200, 200}), PixelBox(0, 0, 90, 90));
    EXPECT_EQ(glance::still_box({190, 190, 200, 200}, {200, 200}), PixelBox(160, 160, 200, 200));
    EXPECT_EQ(glance::still_box({0, 0, 200, 60}, {200, 60}), PixelBox(70, 0, 130, 60));
}

TEST(Crops, AreOfTheFrameInWhichTheObjectIsSeenBest) {
    glance::Crops crops;
    const video::Frame early = frame_of(1, {200, 200});
    const video::Frame late = frame_of(2, {200, 200});
    crops.keep(7, {{1, 1}, {100, 90, 120, 130}, 5}, early);
    crops.keep(7, {{2, 2}, {100, 90, 120, 130}, 6}, late);
    const glance::Crop* const crop = crops.find(event_of({3, 7}));
    ASSERT_NE(crop, nullptr);
    EXPECT_EQ(crop->at.frame, 2);
    EXPECT_EQ(crop->picture.at(0, 0), (Bgr{80, 80, 2}));
    EXPECT_EQ(crop->object, PixelBox(20, 10, 40, 50));
    EXPECT_EQ(crops.find(event_of({3})), nullptr);
}

TEST(Crops, OfSeveralTracksAreTheEventsPortrait) {
    glance::Crops crops;
    const video::Frame frame = frame_of(1, {200, 200});
    crops.keep(1, {{1, 1}, {10, 10, 20, 20}, 9}, frame);
    crops.keep(2, {{4, 4}, {10, 10, 20, 20}, 5}, frame);
    events::Event event = event_of({1, 2});
    EXPECT_EQ(crops.find(event)->at.frame, 1);
    event.portrait = events::Portrait{{4, 4}, {10, 10, 20, 20}, 5};
    EXPECT_EQ(crops.find(event)->at.frame, 4);
}

TEST(Crops, TakeNoMoreMemoryForMoreTracks) {
    glance::Crops crops;
    const video::Frame frame = frame_of(1, {64, 64});
    for (std::size_t track = 0; track < 3000; ++track) {
        crops.keep(track, {{1, 1}, {10, 10, 20, 20}, static_cast<double>(track)}, frame);
    }
    EXPECT_EQ(crops.find(event_of({0})), nullptr);
    EXPECT_NE(crops.find(event_of({2999})), nullptr);
    EXPECT_NE(crops.find(event_of({1976})), nullptr);
    EXPECT_EQ(crops.find(event_of({1975})), nullptr);
}

}  // namespace
}  // namespace vvr
