#include "core/fields/region.h"

#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/errors.h"

namespace vvr {
namespace {

constexpr Size video{200, 100};
constexpr Size field{100, 50};

std::ptrdiff_t inside(const Plane<std::uint8_t>& region) {
    return std::ranges::count(region.pixels(), 255);
}

TEST(Region, NothingAskedForIsEverywhere) {
    EXPECT_TRUE(fields::make_region({}, field, video).empty());
}

TEST(Region, PolygonsAreInPixelsOfTheVideo) {
    fields::FieldOptions options{.roi = "40,20 120,20 120,60 40,60"};
    const Plane<std::uint8_t> region = fields::make_region(options, field, video);
    EXPECT_EQ(region.size(), field);
    EXPECT_EQ(region.at(40, 20), 255);
    EXPECT_EQ(region.at(18, 20), 0);
    EXPECT_EQ(region.at(62, 20), 0);
    EXPECT_EQ(region.at(40, 7), 0);
    EXPECT_EQ(region.at(40, 32), 0);
    EXPECT_NEAR(static_cast<double>(inside(region)), 40 * 20, 62);
}

TEST(Region, MaskIsTakenOut) {
    fields::FieldOptions options{.mask = "0,0 80,0 80,20 0,20; 160,80 200,80 200,100 160,100"};
    const Plane<std::uint8_t> region = fields::make_region(options, field, video);
    EXPECT_EQ(region.at(10, 5), 0) << "the camera's clock";
    EXPECT_EQ(region.at(95, 45), 0);
    EXPECT_EQ(region.at(50, 30), 255);
    options.roi = "0,0 100,0 100,100 0,100";
    const Plane<std::uint8_t> both = fields::make_region(options, field, video);
    EXPECT_EQ(both.at(10, 5), 0);
    EXPECT_EQ(both.at(10, 30), 255);
    EXPECT_EQ(both.at(70, 30), 0);
}

TEST(Region, PolygonsMayCrossTheEdges) {
    fields::FieldOptions options{.roi = "-1000,-1000 100,-1000 100,1000 -1000,1000"};
    const Plane<std::uint8_t> region = fields::make_region(options, field, video);
    EXPECT_EQ(region.at(0, 0), 255);
    EXPECT_EQ(region.at(0, 49), 255);
    EXPECT_EQ(region.at(47, 25), 255);
    EXPECT_EQ(region.at(53, 25), 0);
    options.roi = "-100000,-100000 100000,-100000 100000,100000 -100000,100000";
    EXPECT_EQ(inside(fields::make_region(options, field, video)), field.width * field.height);
}

TEST(Region, NothingToLookAtIsAnError) {
    fields::FieldOptions options{.roi = "500,500 600,500 600,600"};
    test::expect_error(ErrorCode::option_value_out_of_range, [&] { fields::make_region(options, field, video); },
                       {"200x100"});
    options.mask = std::exchange(options.roi, "");
    EXPECT_EQ(inside(fields::make_region(options, field, video)), field.width * field.height)
        << "a mask may lie outside";
}

}  // namespace
}  // namespace vvr
