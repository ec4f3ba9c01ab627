#include "core/annotation/crops.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/planes.h"

namespace vvr {
namespace {

/// Each pixel says where it is.
media::Frame frame_of(std::int64_t index, Size size) {
    return {
        index, static_cast<double>(index), Plane<std::uint8_t>(size), test::plane_of<Bgr>(size, [&](int i, int j) {
            return Bgr{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j), static_cast<std::uint8_t>(index)};
        })};
}

tracking::Event event_of(std::vector<std::size_t> tracks) {
    tracking::Event event;
    event.tracks = std::move(tracks);
    return event;
}

TEST(StillBox, IsASquareAroundTheObjectWithinTheFrame) {
    EXPECT_EQ(annotation::still_box({100, 90, 120, 130}, {200, 200}), (PixelBox{80, 80, 140, 140}));
    EXPECT_EQ(annotation::still_box({0, 0, 10, 60}, {200, 200}), (PixelBox{0, 0, 90, 90}));
    EXPECT_EQ(annotation::still_box({190, 190, 200, 200}, {200, 200}), (PixelBox{160, 160, 200, 200}));
    EXPECT_EQ(annotation::still_box({0, 0, 200, 60}, {200, 60}), (PixelBox{70, 0, 130, 60}));
}

/// Compression changes values a little.
void expect_near(const Bgr& pixel, const Bgr& expected) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(pixel[c], expected[c], 4) << "channel " << c;
}

TEST(Crops, AreOfTheFrameInWhichTheObjectIsSeenBest) {
    annotation::Crops crops;
    const media::Frame early = frame_of(1, {200, 200});
    const media::Frame late = frame_of(200, {200, 200});
    crops.keep(7, {{1, 1}, {100, 90, 120, 130}, 5}, early);
    crops.keep(7, {{200, 200}, {100, 90, 120, 130}, 6}, late);
    const annotation::Crop* const crop = crops.find(event_of({3, 7}));
    ASSERT_NE(crop, nullptr);
    EXPECT_EQ(crop->at().frame, 200);
    EXPECT_EQ(crops.bytes(), crop->bytes());
    EXPECT_EQ(crops.find(event_of({3})), nullptr);
}

TEST(Crops, OfObjectsThatAreOverAreForgotten) {
    annotation::Crops crops(2);
    for (const double seconds : {1.0, 5.0, 9.0}) {
        const auto index = static_cast<std::int64_t>(seconds);
        for (const std::size_t track : {std::size_t{1}, std::size_t{2}}) {
            crops.keep(track, {{index, seconds}, {100, 90, 120, 130}, seconds}, frame_of(index, {200, 200}));
        }
    }
    crops.forget_before(9, [](std::size_t track) { return track == 1; });
    EXPECT_EQ(crops.all(event_of({1})).size(), 1U) << "only that of second 9";
    EXPECT_EQ(crops.all(event_of({2})).size(), 2U);
    crops.forget_before(10, [](std::size_t) { return true; });
    EXPECT_EQ(crops.find(event_of({1, 2})), nullptr);
    EXPECT_EQ(crops.bytes(), 0U);
}

TEST(Crops, ShowTheObjectWithLittleOrMuchAroundIt) {
    annotation::Crops crops;
    crops.keep(7, {{1, 1}, {100, 90, 120, 130}, 5}, frame_of(1, {200, 200}));
    const annotation::Crop& crop = *crops.find(event_of({7}));
    const annotation::ObjectPicture still = crop.still();
    EXPECT_EQ(still.picture.size(), (Size{60, 60}));
    EXPECT_EQ(still.object, (PixelBox{20, 10, 40, 50}));
    EXPECT_EQ(still.scale, 1);
    expect_near(still.picture.at(0, 0), {80, 80, 1});
    expect_near(still.picture.at(59, 59), {139, 139, 1});
    const annotation::ObjectPicture wide = crop.surroundings();
    EXPECT_EQ(wide.picture.size(), (Size{100, 100}));
    EXPECT_EQ(wide.object, (PixelBox{40, 30, 60, 70}));
    expect_near(wide.picture.at(0, 0), {60, 60, 1});
    expect_near(wide.picture.at(99, 99), {159, 159, 1});
}

TEST(Crops, StayWithinTheFrame) {
    for (const PixelBox& object : {PixelBox{0, 0, 10, 60}, PixelBox{190, 150, 200, 160}, PixelBox{0, 0, 200, 160},
                                   PixelBox{33, 71, 90, 80}, PixelBox{0, 0, 1, 1}}) {
        annotation::Crops crops;
        crops.keep(7, {{1, 1}, object, 5}, frame_of(1, {200, 160}));
        const annotation::Crop& crop = *crops.find(event_of({7}));
        const PixelBox still = annotation::still_box(object, {200, 160});
        EXPECT_EQ(crop.still().picture.size(), still.size());
        EXPECT_EQ(crop.still().object, object.translated(-still.left, -still.top));
        expect_near(crop.still().picture.at(0, 0),
                    {static_cast<std::uint8_t>(still.left), static_cast<std::uint8_t>(still.top), 1});
        EXPECT_EQ(crop.surroundings().object.size(), object.size());
    }
}

TEST(Crops, HaveALongestSide) {
    annotation::Crops crops;
    crops.keep(7, {{1, 1}, {0, 0, 600, 300}, 5}, frame_of(1, {1200, 1000}));
    const annotation::ObjectPicture wide = crops.find(event_of({7}))->surroundings();
    EXPECT_EQ(wide.picture.size(), (Size{560, 560}));
    EXPECT_EQ(wide.scale, 0.56);
    EXPECT_EQ(wide.object, (PixelBox{0, 0, 336, 168}));
}

TEST(Crops, OfSeveralTracksAreTheEventsPortrait) {
    annotation::Crops crops;
    const media::Frame frame = frame_of(1, {200, 200});
    crops.keep(1, {{1, 1}, {10, 10, 20, 20}, 9}, frame);
    crops.keep(2, {{4, 4}, {10, 10, 20, 20}, 5}, frame);
    tracking::Event event = event_of({1, 2});
    EXPECT_EQ(crops.find(event)->at().frame, 1);
    event.portrait = tracking::Portrait{{4, 4}, {10, 10, 20, 20}, 5};
    EXPECT_EQ(crops.find(event)->at().frame, 4);
}

TEST(Crops, OfEarlierMomentsAreASecondApart) {
    annotation::Crops crops(3);
    const media::Frame frame = frame_of(1, {200, 200});
    for (int tenth = 0; tenth <= 40; ++tenth) {
        const Moment now{tenth, tenth / 10.0};
        crops.keep(1, {now, {10, 10, 20, 20}, 5.0 + tenth}, frame);
        crops.keep(2, {now, {10, 10, 20, 20}, 4.0 + tenth}, frame);
    }
    std::vector<std::pair<std::size_t, std::int64_t>> found;
    for (const auto& [track, crop] : crops.all(event_of({2, 1}))) found.emplace_back(track, crop->at().frame);
    ASSERT_EQ(found.size(), 6U);
    EXPECT_EQ(found[0], std::pair(std::size_t{1}, std::int64_t{40})) << "the best of each track comes first";
    EXPECT_EQ(found[1], std::pair(std::size_t{2}, std::int64_t{40}));
    EXPECT_EQ(found[2].first, 1U);
    EXPECT_LT(found[2].second, 40);
    EXPECT_LE(found[4].second, found[2].second - 10);
    EXPECT_EQ(crops.find(event_of({1}))->at().frame, 40);
}

TEST(Crops, SayWhereTheyAreInTheField) {
    annotation::Crops crops;
    crops.keep(1, {{1, 1}, {100, 90, 120, 130}, 9}, frame_of(1, {200, 200}));
    for (const annotation::ObjectPicture& shown :
         {crops.find(event_of({1}))->still(), crops.find(event_of({1}))->surroundings()}) {
        EXPECT_EQ(shown.in_field(shown.object), (PixelBox{100, 90, 120, 130}));
    }
}

TEST(Crops, TakeNoMoreMemoryForMoreTracks) {
    annotation::Crops crops;
    const media::Frame frame = frame_of(1, {64, 64});
    for (std::size_t track = 0; track < 3000; ++track) {
        crops.keep(track, {{1, 1}, {10, 10, 20, 20}, static_cast<double>(track)}, frame);
    }
    EXPECT_EQ(crops.find(event_of({0})), nullptr);
    EXPECT_NE(crops.find(event_of({2999})), nullptr);
    EXPECT_NE(crops.find(event_of({1976})), nullptr);
    EXPECT_EQ(crops.find(event_of({1975})), nullptr);
}

TEST(Crops, OfDetailTakeNoMoreMemoryThanTheirLimit) {
    const media::Frame frame{1, 1, Plane<std::uint8_t>({416, 416}), test::noise({416, 416}, 3)};
    annotation::Crops crops;
    for (std::size_t track = 0; track < 260; ++track) {
        crops.keep(track, {{1, 1}, {100, 100, 300, 300}, static_cast<double>(track)}, frame);
        ASSERT_LE(crops.bytes(), annotation::Crops::max_bytes);
    }
    EXPECT_GT(crops.bytes(), annotation::Crops::max_bytes - 500'000);
    EXPECT_EQ(crops.find(event_of({0})), nullptr);
    EXPECT_NE(crops.find(event_of({259})), nullptr);
}

}  // namespace
}  // namespace vvr
