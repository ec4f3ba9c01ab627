#include "core/fields/stabilizer.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/scene/camera.h"
#include "tests/unit/fields/pictures.h"

namespace vvr {
namespace {

using test::fields_of;

constexpr Size shaken_size{192, 144};

media::Frame rough(double dx, double dy) {
    return {0, 0, test::grey_plane(shaken_size, [&](int i, int j) { return test::rough_texture(i - dx, j - dy); }), {}};
}

fields::Planes planes_of(const media::Frame& frame) {
    return {frame.grey, frame.colour};
}

TEST(Stabilizer, FindsAShift) {
    const fields::Stabilizer stabilizer(planes_of(rough(0, 0)));
    for (const auto& [x, y] : {fields::Shift{0, 0}, fields::Shift{0.4, -0.3}, fields::Shift{6, -6},
                               fields::Shift{-5.5, 3.25}, fields::Shift{14, 9}}) {
        const fields::Shift found = stabilizer.shift_of(rough(x, y).grey);
        EXPECT_NEAR(found.x, x, 0.1);
        EXPECT_NEAR(found.y, y, 0.1);
    }
}

TEST(Stabilizer, WhatMovesByItselfIsNotTheCamera) {
    const fields::Stabilizer stabilizer(planes_of(rough(0, 0)));
    media::Frame frame = rough(4, -3);
    const media::Frame crowd = rough(-7, 2);
    for (int j = 0; j < shaken_size.height; ++j) {  // four tenths of the picture
        std::copy_n(crowd.grey.row(j).begin(), 4 * shaken_size.width / 10, frame.grey.row(j).begin());
    }
    const fields::Shift found = stabilizer.shift_of(frame.grey);
    EXPECT_NEAR(found.x, 4, 0.2);
    EXPECT_NEAR(found.y, -3, 0.2);
}

TEST(Stabilizer, NothingToSeeIsNoShift) {
    const fields::Stabilizer stabilizer({test::flat_frame(shaken_size, 0, 90).grey, {}});
    const fields::Shift shift = stabilizer.shift_of(rough(3, 3).grey);
    EXPECT_EQ(shift.x, 0);
    EXPECT_EQ(shift.y, 0);
}

TEST(Stabilizer, AlignsAndTellsWhatItDoesNotSee) {
    const media::Frame here = rough(0, 0);
    const fields::Stabilizer stabilizer(planes_of(here));
    media::Frame frame = rough(5, -3);
    const fields::VisibleArea visible = stabilizer.align(frame, {5, -3});
    EXPECT_EQ(visible.left, 0);
    EXPECT_EQ(visible.right, shaken_size.width - 5);
    EXPECT_EQ(visible.top, 3);
    EXPECT_EQ(visible.bottom, shaken_size.height);
    for (int j = 0; j < shaken_size.height; ++j) {
        for (int i = 0; i < shaken_size.width; ++i) {
            ASSERT_NEAR(frame.grey.at(i, j), here.grey.at(i, j), 1) << i << ", " << j;
        }
    }
    Plane<std::uint8_t> plane(shaken_size, 7);
    fields::clear_outside_overlap(visible, plane);
    EXPECT_EQ(std::ranges::count(plane.pixels(), 7), (shaken_size.width - 5) * (shaken_size.height - 3));
    EXPECT_EQ(plane.at(0, 2), 0);
    EXPECT_EQ(plane.at(0, 3), 7);
}

/// How well fields show what moves: 2 · both / (shown + there), over all frames.
double f_measure(const std::vector<fields::Field>& fields, const generator::Scene& truth) {
    double both = 0, shown = 0, there = 0;
    for (const fields::Field& field : fields) {
        Plane<std::uint8_t> mask(truth.size());
        for (const generator::Object& object : truth.truth(static_cast<int>(field.index)).objects) {
            for (std::size_t i = 0; i < mask.pixels().size(); ++i) mask.pixels()[i] |= object.mask.pixels()[i];
        }
        for (std::size_t i = 0; i < mask.pixels().size(); ++i) {
            const bool is_shown = field.scalar.pixels()[i] != 0;
            const bool is_there = mask.pixels()[i] != 0;
            both += is_shown && is_there ? 1 : 0;
            shown += is_shown ? 1 : 0;
            there += is_there ? 1 : 0;
        }
    }
    return 2 * both / (shown + there);
}

fields::FieldOptions without_flow(const char* stabilize, const char* reference = "median") {
    fields::FieldOptions options;
    options.flow.method = "none";
    options.stabilize = stabilize;
    options.reference = reference;
    return options;
}

TEST(ShakingCamera, ShowsWhatMovesAndNothingElse) {
    generator::Options options{.size = {256, 192}, .frames = 120, .noise = 2};
    const generator::Scene still = generator::make_walkers(options);
    const generator::Scene shaken = generator::make_shaken(still);
    const double best = f_measure(fields_of(still, without_flow("auto")), still);
    for (const char* const reference : {"median", "running"}) {
        const double aligned = f_measure(fields_of(shaken, without_flow("auto", reference)), still);
        const double as_it_is = f_measure(fields_of(shaken, without_flow("off", reference)), still);
        EXPECT_GT(aligned, best - 0.1) << reference << " best " << best;
        EXPECT_LT(as_it_is, aligned - 0.2) << reference;
    }
}

TEST(ShakingCamera, AStillOneIsLeftAlone) {
    generator::Options options{.size = {192, 144}, .frames = 60, .noise = 3, .drift = 20};
    for (const generator::Scene& scene : {generator::make_walkers(options), generator::make_left_bag(options)}) {
        const std::vector<fields::Field> aligned = fields_of(scene, without_flow("auto"));
        const std::vector<fields::Field> as_it_is = fields_of(scene, without_flow("off"));
        ASSERT_EQ(aligned.size(), as_it_is.size());
        for (std::size_t f = 0; f < aligned.size(); ++f) {
            ASSERT_TRUE(test::same(aligned[f].scalar, as_it_is[f].scalar)) << f;
        }
    }
}

TEST(ShakingCamera, FieldsDoNotDependOnTheNumberOfThreads) {
    generator::Options options{.size = {192, 144}, .frames = 40};
    const generator::Scene shaken = generator::make_shaken(generator::make_walkers(options));
    fields::FieldOptions fields = without_flow("auto");
    fields.threads = 1;
    const std::vector<fields::Field> one = fields_of(shaken, fields);
    fields.threads = 5;
    const std::vector<fields::Field> five = fields_of(shaken, fields);
    ASSERT_EQ(one.size(), five.size());
    for (std::size_t f = 0; f < one.size(); ++f) {
        ASSERT_TRUE(test::same(one[f].scalar, five[f].scalar)) << f;
    }
}

}  // namespace
}  // namespace vvr
