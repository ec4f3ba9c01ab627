#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/fields/filter.h"
#include "tests/unit/fields_pictures.h"

namespace vvr {
namespace {

constexpr Size size{48, 32};

Plane<std::uint8_t> difference(const Frame& frame, const Frame& reference, int threshold = 24) {
    FieldOptions options;
    options.threshold = threshold;
    const auto filter = find_filter("difference").make(options, {reference.grey, reference.colour});
    return (*filter)({frame, nullptr, nullptr});
}

TEST(Difference, ShowsAnObjectAndNothingElse) {
    Frame empty = test::texture_frame(size, 0, 0, 0);
    for (std::uint8_t& p : empty.grey.pixels()) p /= 2;
    Frame frame = empty;
    for (int j = 10; j < 20; ++j) {
        for (int i = 20; i < 30; ++i) frame.grey.at(i, j) = static_cast<std::uint8_t>(empty.grey.at(i, j) + 120);
    }
    const Plane<std::uint8_t> scalar = difference(frame, empty);
    for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i) {
            const bool well_inside = i >= 21 && i < 29 && j >= 11 && j < 19;
            const bool well_outside = i < 19 || i > 30 || j < 9 || j > 20;
            EXPECT_GE(scalar.at(i, j), well_inside ? 200 : 0) << i << ", " << j;
            EXPECT_LE(scalar.at(i, j), well_outside ? 0 : 255) << i << ", " << j;
        }
    }
}

TEST(Difference, StartsAtTheThreshold) {
    const Frame dark = test::flat_frame(size, 0, 100);
    EXPECT_EQ(difference(test::flat_frame(size, 0, 123), dark).at(5, 5), 0);
    EXPECT_EQ(difference(test::flat_frame(size, 0, 124), dark).at(5, 5), 48);
    EXPECT_EQ(difference(test::flat_frame(size, 0, 76), dark).at(5, 5), 48) << "darker counts like brighter";
    EXPECT_EQ(difference(test::flat_frame(size, 0, 255), dark).at(5, 5), 255);
}

TEST(Difference, ColourCounts) {
    Frame empty = test::flat_frame(size, 0, 100);
    Frame frame = empty;
    empty.colour = Plane<Bgr>(size, {100, 100, 100});
    frame.colour = Plane<Bgr>(size, {140, 80, 100});
    EXPECT_EQ(difference(frame, empty).at(3, 3), 80) << "the largest channel difference";
    frame.colour = {};
    EXPECT_EQ(difference(frame, empty).at(3, 3), 0) << "grey alone sees nothing";
}

TEST(Difference, SensorNoiseStaysDark) {
    const Frame empty = test::texture_frame(size, 0, 0, 0);
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0, 5);
    Frame frame = empty;
    for (std::uint8_t& p : frame.grey.pixels())
        p = static_cast<std::uint8_t>(std::clamp(p + noise(random), 0.0, 255.0));
    EXPECT_EQ(std::ranges::count(difference(frame, empty).pixels(), 0), size.width * size.height);
}

TEST(Difference, SmallestPictures) {
    for (const Size tiny : {Size{1, 1}, Size{3, 2}, Size{1, 7}}) {
        const Plane<std::uint8_t> scalar = difference(test::flat_frame(tiny, 0, 200), test::flat_frame(tiny, 0, 100));
        EXPECT_EQ(scalar.size(), tiny);
        EXPECT_EQ(std::ranges::count(scalar.pixels(), 200), tiny.width * tiny.height);
    }
}

TEST(FilterTable, UnknownNameSaysWhatThereIs) {
    try {
        find_filter("diference");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("diference"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("difference"), std::string::npos);
    }
}

}  // namespace
}  // namespace vvr
