#include <vector>

#include <gtest/gtest.h>

#include "core/fields/median_scene.h"
#include "core/fields/running_reference.h"
#include "tests/unit/fields/pictures.h"

namespace vvr {
namespace {

TEST(Reference, MedianForgetsWhoPassedBy) {
    std::vector<video::Frame> frames;
    for (int f = 0; f < 9; ++f) {
        frames.push_back(test::texture_frame({40, 7}, 0, 0, 0));
        frames.back().grey.at(4 * f, 3) = 255;
        frames.back().grey.at(4 * f + 1, 3) = 0;
    }
    const fields::Planes reference = fields::median_reference(frames);
    const video::Frame empty = test::texture_frame({40, 7}, 0, 0, 0);
    EXPECT_TRUE(test::same(reference.grey, empty.grey));
    EXPECT_TRUE(reference.colour.empty());
}

TEST(Reference, IsWithoutWhoStoodThereForMostOfTheClip) {
    const PixelBox person{4, 2, 8, 7};
    const PixelBox box{12, 4, 15, 7};  // a box is no living thing
    std::vector<video::Frame> frames;
    for (int f = 0; f < 24; ++f) {
        video::Frame& frame = frames.emplace_back(test::flat_frame({20, 8}, f, 90));
        if (f < 16) fill(frame.grey, person, 200);
        if (f >= 12) fill(frame.grey, box, 10);
    }
    fields::Planes scene = fields::lasting_reference(frames);
    EXPECT_EQ(scene.grey.at(5, 4), 200);
    int looks = 0;
    const auto find = [&](const video::Frame& frame) {
        ++looks;
        return frame.grey.at(5, 4) == 200 ? std::vector{person} : std::vector<PixelBox>();
    };
    fields::look_behind(frames, find, scene);
    EXPECT_TRUE(test::same(scene.grey, Plane<std::uint8_t>({20, 8}, 90)));
    EXPECT_EQ(looks, 8);
    looks = 0;
    fields::look_behind(std::span(frames).subspan(16), find, scene);
    EXPECT_EQ(looks, 1) << "nobody is in the first frame";
}

TEST(Reference, MedianIsTheMiddleValue) {
    std::vector<video::Frame> frames;
    for (int level : {200, 3, 77, 255, 0}) {
        frames.push_back(test::flat_frame({3, 2}, 0, static_cast<std::uint8_t>(level)));
    }
    EXPECT_EQ(fields::median_reference(frames).grey.at(2, 1), 77);
    frames.pop_back();
    EXPECT_EQ(fields::median_reference(frames).grey.at(2, 1), 200) << "of four, the upper of the two in the middle";
    frames.resize(1);
    EXPECT_EQ(fields::median_reference(frames).grey.at(2, 1), 200);
    EXPECT_TRUE(fields::median_reference({}).empty());
}

TEST(Reference, MedianTakesEachChannelByItself) {
    std::vector<video::Frame> frames;
    for (const Bgr& colour : {Bgr{10, 50, 90}, Bgr{20, 60, 70}, Bgr{30, 40, 80}}) {
        frames.push_back(test::flat_frame({5, 4}, 0, 9));
        frames.back().colour = Plane<Bgr>({5, 4}, colour);
    }
    EXPECT_EQ(fields::median_reference(frames).colour.at(4, 3), (Bgr{20, 50, 80}));
}

TEST(Reference, WhatWasLeftForMostOfTheClipIsNotTheScene) {
    std::vector<video::Frame> frames;
    for (int f = 0; f < 31; ++f) {
        frames.push_back(test::flat_frame({6, 4}, f, static_cast<std::uint8_t>(100 + f % 3)));
        frames.back().colour = Plane<Bgr>({6, 4}, {90, 100, 110});
        if (f >= 9 && f < 29) {
            frames.back().grey.at(2, 2) = 160;
            frames.back().colour.at(2, 2) = {90, 160, 110};
        }
        if (f < 2) frames.back().grey.at(4, 1) = 10;  // somebody stood there at the beginning
        if (f < 2) frames.back().colour.at(4, 1) = {10, 10, 10};
    }
    EXPECT_EQ(fields::median_reference(frames).grey.at(2, 2), 160);
    const fields::Planes reference = fields::lasting_reference(frames);
    EXPECT_EQ(reference.colour.at(2, 2), (Bgr{90, 100, 110}));
    EXPECT_NEAR(reference.grey.at(2, 2), 101, 1);
    EXPECT_EQ(reference.colour.at(4, 1), (Bgr{90, 100, 110}));
    for (video::Frame& frame : frames) frame.colour = {};
    EXPECT_NEAR(fields::lasting_reference(frames).grey.at(2, 2), 101, 1);
    EXPECT_NEAR(fields::lasting_reference(frames).grey.at(4, 1), 101, 1);
}

fields::Planes flat(std::uint8_t level) {
    return {Plane<std::uint8_t>({40, 30}, level), {}};
}

TEST(RunningReference, FollowsTheSceneAndNotTheObject) {
    fields::RunningReference running(flat(100));
    Plane<std::uint8_t> object({40, 30});
    object.at(20, 15) = 255;
    for (int f = 0; f < 500; ++f) running.adapt(flat(120), object, {});
    EXPECT_EQ(running.now().grey.at(2, 2), 120);
    EXPECT_EQ(running.now().grey.at(20, 15), 100) << "what was left behind is not swallowed";
    EXPECT_EQ(running.now().grey.at(22, 16), 100) << "nor are its soft edges";
}

TEST(RunningReference, KeepsUpWithSlowChanges) {
    fields::RunningReference running(flat(100));
    const Plane<std::uint8_t> nothing({40, 30});
    for (int f = 0; f < 800; ++f) {
        const int level = 100 + f / 10;
        running.adapt(flat(static_cast<std::uint8_t>(level)), nothing, {});
        ASSERT_NEAR(running.now().grey.at(5, 5), level, 5) << f;
    }
}

TEST(RunningReference, LightChangesBehindObjectsToo) {
    fields::RunningReference running(flat(100));
    running.adapt(flat(120), Plane<std::uint8_t>({40, 30}, 255), {.gain = 1.2, .offset = 5});
    EXPECT_EQ(running.now().grey.at(20, 15), 125);
}

/// A square in the middle, as an object shows it.
Plane<std::uint8_t> square(Size picture, std::uint8_t about, std::uint8_t inside) {
    Plane<std::uint8_t> plane(picture, about);
    fill(plane, {20, 20, 40, 40}, inside);
    return plane;
}

TEST(RunningReference, AGhostIsLetGoAndWhatWasLeftIsNot) {
    const Size picture{64, 64};
    const Plane<std::uint8_t> object = square(picture, 0, 120);
    const Plane<std::uint8_t> bare(picture, 100);
    const Plane<std::uint8_t> with_thing = square(picture, 100, 160);
    fields::RunningReference stood({with_thing, {}});  // who stood there while it was learnt has gone
    fields::RunningReference left({bare, {}});
    for (int f = 0; f < 100; ++f) {
        stood.adapt({bare, {}}, object, {});
        left.adapt({with_thing, {}}, object, {});
    }
    EXPECT_EQ(stood.now().grey.at(30, 30), 160) << "too early to know";
    for (int f = 0; f < 300; ++f) {
        stood.adapt({bare, {}}, object, {});
        left.adapt({with_thing, {}}, object, {});
    }
    EXPECT_EQ(stood.now().grey.at(30, 30), 100);
    EXPECT_EQ(stood.now().grey.at(20, 20), 100);
    EXPECT_EQ(left.now().grey.at(30, 30), 100);
}

}  // namespace
}  // namespace vvr
