// What makes a good mask of a difference: thresholds by noise, blobs, holes, shadows.
#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/fields/blobs.h"
#include "core/fields/median_scene.h"
#include "core/fields/object.h"
#include "core/fields/reference.h"
#include "core/fields/shadows.h"
#include "tests/unit/fields/pictures.h"

namespace vvr {
namespace {

constexpr Size mask_size{96, 64};

using test::lit;

void paint(Plane<std::uint8_t>& plane, int left, int top, int width, int height, std::uint8_t value) {
    fill(plane, {left, top, left + width, top + height}, value);
}

TEST(Blobs, FaintOnesGo) {
    Plane<std::uint8_t> plane(mask_size);
    paint(plane, 10, 10, 20, 20, 40);
    paint(plane, 60, 10, 20, 20, 40);
    paint(plane, 65, 15, 2, 2, 50);
    Plane<std::uint8_t> strong(mask_size, 50);
    Plane<std::uint8_t> four = plane;
    fields::apply_hysteresis(four, strong, 4, 20);
    EXPECT_EQ(lit(four), 400) << "the one with four strong pixels stays whole";
    EXPECT_EQ(four.at(15, 15), 0);
    fields::apply_hysteresis(plane, strong, 5, 20);
    EXPECT_EQ(lit(plane), 0);
}

TEST(Blobs, HolesAreFilledAndBaysAreNot) {
    Plane<std::uint8_t> plane(mask_size);
    paint(plane, 10, 10, 30, 30, 40);
    paint(plane, 12, 12, 3, 3, 0);    // a hole
    paint(plane, 20, 20, 10, 10, 0);  // one that is too large
    paint(plane, 38, 30, 2, 4, 0);    // a bay
    paint(plane, 0, 50, 5, 14, 40);   // a hole at the picture's edge is none
    paint(plane, 0, 55, 2, 2, 0);
    Plane<std::uint8_t> differences(mask_size, 7);
    differences.at(21, 21) = 255;
    fields::fill_holes(plane, differences, {.max_area = 20, .least = 8, .value = 48});
    EXPECT_EQ(std::ranges::count(plane.pixels(), 48), 0) << "the scene is seen through it";
    fields::fill_holes(plane, differences, {.max_area = 20, .least = 7, .value = 48});
    EXPECT_EQ(std::ranges::count(plane.pixels(), 48), 9);
    EXPECT_EQ(plane.at(13, 13), 48);
    fields::fill_holes(plane, differences, {.max_area = 100, .least = 9, .value = 48});
    EXPECT_EQ(std::ranges::count(plane.pixels(), 48), 109) << "the mean counts";
    Plane<std::uint8_t> corner(mask_size);
    paint(corner, 10, 10, 30, 30, 40);
    paint(corner, 20, 20, 10, 10, 0);
    paint(corner, 30, 30, 2, 2, 0);
    fields::fill_holes(corner, differences, {.max_area = 20, .least = 7, .value = 48});
    EXPECT_EQ(corner.at(30, 30), 48) << "holes that touch at a corner are two";
    Plane<std::uint8_t> nothing(mask_size);
    fields::fill_holes(nothing, differences, {.max_area = mask_size.width * mask_size.height});
    EXPECT_EQ(lit(nothing), 0);
}

TEST(Shadows, WhatIsEnclosedByAThingIsPartOfIt) {
    Plane<std::uint8_t> object(mask_size);
    Plane<std::uint8_t> shadow(mask_size);
    paint(object, 20, 20, 20, 20, 100);
    paint(object, 25, 20, 10, 5, 0);  // a roof: open above
    paint(shadow, 25, 20, 10, 5, 30);
    paint(shadow, 41, 38, 12, 2, 30);  // beside its feet
    std::vector<fields::ShadowPixel> taken;
    for (int j = 0; j < mask_size.height; ++j) {
        for (int i = 0; i < mask_size.width; ++i) {
            if (shadow.at(i, j) != 0) taken.push_back({i, j, shadow.at(i, j)});
        }
    }
    fields::restore_enclosed(object, taken, 16, 20);
    EXPECT_EQ(std::ranges::count(object.pixels(), 30), 50);
    EXPECT_EQ(object.at(30, 20), 30);
    EXPECT_EQ(object.at(45, 38), 0);
}

std::vector<media::Frame> noisy(const media::Frame& empty, double sigma, int count) {
    std::mt19937 random(3);
    std::vector<media::Frame> frames;
    for (int k = 0; k < count; ++k) frames.push_back(test::seen(empty, 1, 0, sigma, random));
    return frames;
}

TEST(Noise, IsAboutTheMedianDifference) {
    const media::Frame empty = test::flat_frame(mask_size, 0, 100);
    for (const double sigma : {0.0, 3.0, 8.0}) {
        const Plane<std::uint8_t> noise = fields::noise_of(noisy(empty, sigma, 31), {empty.grey, {}}, 0);
        double sum = 0;
        for (const int p : noise.pixels()) sum += p;
        // The largest of the neighbours' means is a little more.
        EXPECT_NEAR(sum / static_cast<double>(noise.pixels().size()), 0.67 * sigma * 1.25, 0.1 + 0.25 * sigma) << sigma;
    }
}

TEST(Noise, IsKnownFromEightFramesOn) {
    const media::Frame empty = test::flat_frame(mask_size, 0, 100);
    EXPECT_TRUE(fields::noise_of(noisy(empty, 3, 7), {empty.grey, {}}, 0).empty());
    for (const int frames : {8, 16, 23}) {  // a clip with 16 key frames has 16 frames of the empty scene
        const Plane<std::uint8_t> noise = fields::noise_of(noisy(empty, 3, frames), {empty.grey, {}}, 0);
        ASSERT_EQ(noise.size(), mask_size) << frames;
        EXPECT_GE(*std::ranges::min_element(noise.pixels()), 1) << frames;
    }
}

TEST(Noise, WhoeverStandsThereForMostOfTheTimeIsNone) {
    const media::Frame empty = test::flat_frame(mask_size, 0, 100);
    std::vector<media::Frame> frames = noisy(empty, 2, 31);
    for (std::size_t k = 9; k < frames.size(); ++k) paint(frames[k].grey, 40, 20, 20, 30, 200);
    const Plane<std::uint8_t> noise = fields::noise_of(frames, {empty.grey, {}}, 0);
    EXPECT_LT(*std::ranges::max_element(noise.pixels()), 12);
}

// Leaves sway on the left: what lights up there now and then is no object, and on the right it is.
TEST(Noise, RaisesTheThresholdWhereTheSceneIsRestless) {
    const media::Frame empty = test::flat_frame(mask_size, 0, 100);
    fields::Reference reference(fields::Planes{empty.grey, {}});
    reference.noise = Plane<std::uint8_t>(mask_size);
    paint(reference.noise, 0, 0, 48, mask_size.height, 8);
    const Plane<std::uint8_t> everywhere;
    fields::FieldOptions options{.smooth = 0, .illumination = "none"};
    const fields::ObjectFinder finder(options, 24, reference, everywhere);
    media::Frame frame = empty;
    paint(frame.grey, 10, 10, 12, 12, 132);
    paint(frame.grey, 60, 10, 12, 12, 132);
    Plane<std::uint8_t> object = finder.find({frame.grey, {}}).values;
    EXPECT_EQ(lit(object), 144);
    EXPECT_NE(object.at(65, 15), 0);
    paint(frame.grey, 10, 10, 12, 12, 160);
    object = finder.find({frame.grey, {}}).values;
    EXPECT_EQ(lit(object), 288) << "a person before the leaves still shows";
}

// Only the shirt reaches the threshold; the trousers belong to it, and a faint cloud beside it doesn't count.
TEST(Noise, WeakPartsOfAThingShowWithIt) {
    const media::Frame empty = test::flat_frame(mask_size, 0, 100);
    const Plane<std::uint8_t> everywhere;
    fields::FieldOptions options{.smooth = 0, .illumination = "none"};
    const fields::ObjectFinder finder(options, 24, fields::Planes{empty.grey, {}}, everywhere);
    media::Frame frame = empty;
    paint(frame.grey, 20, 10, 10, 15, 150);
    paint(frame.grey, 20, 25, 10, 15, 120);
    paint(frame.grey, 60, 25, 10, 15, 120);
    const Plane<std::uint8_t> object = finder.find({frame.grey, {}}).values;
    EXPECT_EQ(lit(object), 300);
    EXPECT_EQ(object.at(25, 30), 40);
    EXPECT_EQ(object.at(65, 30), 0);
}

}  // namespace
}  // namespace vvr
