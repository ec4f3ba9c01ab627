#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "core/fields/object.h"
#include "tests/unit/fields/pictures.h"

namespace vvr {
namespace {

constexpr Size pair_size{96, 64};
constexpr int pixels = pair_size.width * pair_size.height;

Plane<std::uint8_t> object_in(const media::Frame& frame, const media::Frame& empty, const fields::FieldOptions& options,
                              const Plane<std::uint8_t>& region = {}) {
    const fields::ObjectFinder finder(options, 24, fields::Planes{empty.grey, empty.colour}, region);
    return finder.find(fields::smoothed(frame.grey, frame.colour, options.smooth)).values;
}

/// Every pixel counts, in whatever light.
fields::FieldOptions plain() {
    fields::FieldOptions options{.smooth = 0, .min_area = 0, .illumination = "none"};
    return options;
}

using test::lit;

media::Frame dark_texture() {
    media::Frame frame = test::texture_frame(pair_size, 0, 0, 0);
    for (std::uint8_t& p : frame.grey.pixels()) p = static_cast<std::uint8_t>(20 + p / 2);
    return frame;
}

/// A square of 20 × 20 pixels that is brighter than what is behind it.
media::Frame with_object(const media::Frame& empty) {
    media::Frame frame = empty;
    for (int j = 20; j < 40; ++j) {
        for (int i = 40; i < 60; ++i) frame.grey.at(i, j) = static_cast<std::uint8_t>(empty.grey.at(i, j) + 90);
    }
    return frame;
}

media::Frame seen(const media::Frame& frame, double gain, double offset, double sigma, unsigned seed) {
    std::mt19937 random(seed);
    return test::seen(frame, gain, offset, sigma, random);
}

void expect_only_the_object(const Plane<std::uint8_t>& object) {
    for (int j = 0; j < pair_size.height; ++j) {
        for (int i = 0; i < pair_size.width; ++i) {
            const bool well_inside = i >= 41 && i < 59 && j >= 21 && j < 39;
            const bool well_outside = i < 38 || i > 61 || j < 18 || j > 41;
            EXPECT_GE(object.at(i, j), well_inside ? 48 : 0) << i << ", " << j;
            EXPECT_LE(object.at(i, j), well_outside ? 0 : 255) << i << ", " << j;
        }
    }
}

TEST(Difference, ShowsAnObjectAndNothingElse) {
    const media::Frame empty = dark_texture();
    expect_only_the_object(object_in(with_object(empty), empty, {}));
}

TEST(Difference, StartsAtTheThreshold) {
    const media::Frame dark = test::flat_frame(pair_size, 0, 100);
    EXPECT_EQ(object_in(test::flat_frame(pair_size, 0, 123), dark, plain()).at(5, 5), 0);
    EXPECT_EQ(object_in(test::flat_frame(pair_size, 0, 124), dark, plain()).at(5, 5), 48);
    EXPECT_EQ(object_in(test::flat_frame(pair_size, 0, 76), dark, plain()).at(5, 5), 48)
        << "darker counts like brighter";
    EXPECT_EQ(object_in(test::flat_frame(pair_size, 0, 227), dark, plain()).at(5, 5), 254);
    EXPECT_EQ(object_in(test::flat_frame(pair_size, 0, 255), dark, plain()).at(5, 5), 255);
}

TEST(Difference, ColourCounts) {
    for (const Size odd : {pair_size, Size{67, 3}, Size{1, 1}}) {
        media::Frame empty = test::flat_frame(odd, 0, 100);
        media::Frame frame = empty;
        empty.colour = Plane<Bgr>(odd, {100, 100, 100});
        frame.colour = Plane<Bgr>(odd, {140, 80, 100});
        const Plane<std::uint8_t> object = object_in(frame, empty, plain());
        EXPECT_EQ(std::ranges::count(object.pixels(), 80), std::ssize(object.pixels()))
            << "the largest of the channels'";
        frame.colour = {};
        EXPECT_EQ(lit(object_in(frame, empty, plain())), 0) << "grey alone sees nothing";
    }
}

TEST(Difference, SmallBlobsAreRemoved) {
    const media::Frame empty = test::flat_frame(pair_size, 0, 100);
    media::Frame frame = empty;
    for (int i = 10; i < 19; ++i) frame.grey.at(i, 30) = 200;          // nine in a row
    for (int k = 0; k < 10; ++k) frame.grey.at(50 + k, 20 + k) = 200;  // ten that touch at their corners
    fields::FieldOptions options = plain();
    options.min_area = 10;
    const Plane<std::uint8_t> object = object_in(frame, empty, options);
    EXPECT_EQ(lit(object), 10);
    EXPECT_NE(object.at(55, 25), 0);
    options.min_area = 11;
    EXPECT_EQ(lit(object_in(frame, empty, options)), 0);
}

TEST(Difference, BlobsOfAnyShapeAreOne) {
    const media::Frame empty = test::flat_frame(pair_size, 0, 100);
    media::Frame frame = empty;
    int drawn = 0;
    for (int j = 5; j < 35; ++j) {  // a comb, whose teeth meet only in its last row, and a lone ring around nothing
        for (int i = 5; i < 45; ++i) {
            if (j < 34 && i % 4 != 0) continue;
            frame.grey.at(i, j) = 200;
            ++drawn;
        }
    }
    fields::FieldOptions options = plain();
    options.min_area = drawn;
    EXPECT_EQ(lit(object_in(frame, empty, options)), drawn);
    options.min_area = drawn + 1;
    EXPECT_EQ(lit(object_in(frame, empty, options)), 0);
}

TEST(Difference, OnlyTheRegionIsLookedAt) {
    Plane<std::uint8_t> region(pair_size, 255);
    fill(region, {0, 0, pair_size.width, 30}, 0);
    const Plane<std::uint8_t> object =
        object_in(test::flat_frame(pair_size, 0, 200), test::flat_frame(pair_size, 0, 100), plain(), region);
    EXPECT_EQ(lit(object), pixels - 30 * pair_size.width);
    EXPECT_EQ(object.at(40, 29), 0);
}

TEST(Difference, SensorNoiseStaysDark) {
    const media::Frame empty = dark_texture();
    for (unsigned seed = 1; seed <= 20; ++seed) {
        EXPECT_EQ(lit(object_in(seen(empty, 1, 0, 5, seed), empty, {})), 0);
    }
}

struct Change {
    double gain;
    double offset;
};

TEST(Illumination, ChangesOfLightStayDarkAndObjectsShow) {
    const media::Frame empty = dark_texture();
    for (const char* const kind : {"global", "local"}) {
        fields::FieldOptions options{.illumination = kind};
        for (const auto& [gain, offset] :
             {Change{1.2, 0}, Change{0.8, 0}, Change{1, 40}, Change{1, -15}, Change{1.3, -20}, Change{0.6, 30}}) {
            SCOPED_TRACE(testing::Message() << kind << " " << gain << " L + " << offset);
            EXPECT_EQ(lit(object_in(seen(empty, gain, offset, 5, 3), empty, options)), 0);
            expect_only_the_object(object_in(seen(with_object(empty), gain, offset, 0, 3), empty, options));
        }
    }
    fields::FieldOptions options{.illumination = "none"};
    EXPECT_GT(lit(object_in(seen(empty, 1.4, 0, 0, 3), empty, options)), pixels / 4)
        << "without it nearly all lights up";
}

TEST(Illumination, LocalFollowsALampAtOneSide) {
    media::Frame empty = dark_texture();
    media::Frame frame = empty;
    frame.grey = test::grey_plane(
        pair_size, [&](int i, int j) { return empty.grey.at(i, j) * (0.75 + 0.5 * i / pair_size.width); });
    fields::FieldOptions options{.illumination = "local"};
    EXPECT_EQ(lit(object_in(frame, empty, options)), 0);
    options.illumination = "none";
    EXPECT_GT(lit(object_in(frame, empty, options)), 0);
}

TEST(Illumination, WhatWasCutOffIsNotMadeDarker) {
    media::Frame empty = dark_texture();
    fill(empty.grey, {5, 5, 30, 20}, 255);
    media::Frame frame = seen(empty, 0.8, 0, 0, 1);
    fill(frame.grey, {5, 5, 30, 20}, 255);
    fields::FieldOptions options;
    options.smooth = 0;  // or the cut off places' edges would be something between
    EXPECT_EQ(lit(object_in(frame, empty, options)), 0);
}

TEST(Illumination, NothingToLearnFromIsNoChange) {
    const fields::Planes black{Plane<std::uint8_t>(pair_size, 0), {}};
    const fields::Planes white{Plane<std::uint8_t>(pair_size, 255), {}};
    const fields::Planes tiny{Plane<std::uint8_t>({2, 1}, 100), {}};
    EXPECT_EQ(fields::estimate_illumination(black, white), fields::IlluminationChange{});
    EXPECT_EQ(fields::estimate_illumination(white, white), fields::IlluminationChange{});
    EXPECT_EQ(fields::estimate_illumination(tiny, tiny), fields::IlluminationChange{});
}

TEST(Shadows, AreNotObjectsAndDarkThingsAre) {
    media::Frame empty = dark_texture();
    empty.colour = Plane<Bgr>(pair_size);
    for (std::size_t i = 0; i < empty.colour.pixels().size(); ++i) {
        const auto level = empty.grey.pixels()[i];
        empty.colour.pixels()[i] = {level, static_cast<std::uint8_t>(level + level / 4),
                                    static_cast<std::uint8_t>(level + level / 2)};
    }
    media::Frame frame = empty;
    const auto darken = [&](int left, double b, double g, double r) {
        for (int j = 10; j < 40; ++j) {
            for (int i = left; i < left + 20; ++i) {
                Bgr& p = frame.colour.at(i, j);
                p = {static_cast<std::uint8_t>(std::lround(b * p[0])), static_cast<std::uint8_t>(std::lround(g * p[1])),
                     static_cast<std::uint8_t>(std::lround(r * p[2]))};
            }
        }
    };
    darken(5, 0.68, 0.65, 0.64);  // a shadow
    darken(35, 0.3, 0.28, 0.3);   // a dark coat
    darken(65, 0.45, 0.65, 0.8);  // something red
    fields::FieldOptions options{.illumination = "none"};
    const Plane<std::uint8_t> object = object_in(frame, empty, options);
    EXPECT_EQ(object.at(15, 25), 0);
    EXPECT_NE(object.at(45, 25), 0);
    EXPECT_NE(object.at(75, 25), 0);
    frame = empty;
    darken(5, 1.5, 1.5, 1.5);
    EXPECT_NE(object_in(frame, empty, options).at(15, 25), 0) << "light is no shadow";
    frame = empty;
    darken(5, 0.68, 0.65, 0.64);
    options.shadows = "keep";
    EXPECT_NE(object_in(frame, empty, options).at(15, 25), 0);
}

// An infrared camera writes grey frames with colour channels: every dark thing keeps their "colour".
TEST(Shadows, AreUnknownWhereNothingHasAColour) {
    media::Frame empty = dark_texture();
    empty.colour = Plane<Bgr>(pair_size);
    std::ranges::transform(empty.grey.pixels(), empty.colour.pixels().begin(), [](std::uint8_t level) {
        const auto tinted = static_cast<std::uint8_t>(level + 9);
        return Bgr{tinted, level, level};
    });
    media::Frame frame = empty;
    for (int j = 10; j < 40; ++j) {
        for (int i = 5; i < 25; ++i) {
            for (std::uint8_t& level : frame.colour.at(i, j)) level = static_cast<std::uint8_t>(0.6 * level);
        }
    }
    const fields::FieldOptions options{.illumination = "none"};
    EXPECT_NE(object_in(frame, empty, options).at(15, 25), 0) << "a coat in the night";
    for (media::Frame* const picture : {&frame, &empty}) {
        fill(picture->colour, {50, 0, 60, pair_size.height}, Bgr{40, 90, 160});  // a door
    }
    EXPECT_EQ(object_in(frame, empty, options).at(15, 25), 0) << "there are colours, and none changed";
}

TEST(Planes, FewColouredPixelsAreNoColours) {
    constexpr Size size{100, 60};
    const auto picture = [&](const Bgr& tint, int coloured_columns) {
        Plane<Bgr> colour(size, tint);
        fill(colour, {0, 0, coloured_columns, size.height}, Bgr{40, 90, 160});
        return colour;
    };
    EXPECT_FALSE(fields::has_colours(picture({80, 80, 80}, 0)));
    EXPECT_FALSE(fields::has_colours(picture({90, 80, 74}, 0))) << "a slight tint";
    EXPECT_FALSE(fields::has_colours(picture({90, 80, 74}, 3))) << "a clock in colour";
    EXPECT_TRUE(fields::has_colours(picture({90, 80, 74}, 12)));
    EXPECT_TRUE(fields::has_colours(picture({110, 80, 70}, 0))) << "all of it is blue";
    EXPECT_FALSE(fields::has_colours({}));
}

TEST(Difference, SmallestPictures) {
    for (const Size tiny : {Size{1, 1}, Size{3, 2}, Size{1, 7}}) {
        for (const char* const kind : {"none", "global", "local"}) {
            fields::FieldOptions options{.min_area = 0, .illumination = kind};
            const Plane<std::uint8_t> object =
                object_in(test::flat_frame(tiny, 0, 200), test::flat_frame(tiny, 0, 100), options);
            EXPECT_EQ(object.size(), tiny);
            EXPECT_EQ(lit(object), std::ssize(object.pixels())) << kind;
        }
    }
}

}  // namespace
}  // namespace vvr
