#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/detector/formats.h"

namespace vvr::detector {
namespace {

constexpr Bgr grey{114, 114, 114};
constexpr Bgr red{0, 0, 255};

TEST(Letterbox, PutsAWideImageAtTheTop) {
    const Letterbox letterbox({200, 100}, {64, 64});
    EXPECT_DOUBLE_EQ(letterbox.scale, 0.32);
    EXPECT_EQ(letterbox.content, (Size{64, 32}));
    const auto input = letterboxed(view_of(Plane<Bgr>({200, 100}, red)), {64, 64});
    EXPECT_EQ(input.at(63, 31), red);
    EXPECT_EQ(input.at(0, 32), grey);
    EXPECT_EQ(input.at(63, 63), grey);
}

TEST(Letterbox, PutsATallImageAtTheLeft) {
    const Letterbox letterbox({30, 40}, {64, 64});
    EXPECT_DOUBLE_EQ(letterbox.scale, 1.6);
    EXPECT_EQ(letterbox.content, (Size{48, 64}));
    const auto input = letterboxed(view_of(Plane<Bgr>({30, 40}, red)), {64, 64});
    EXPECT_EQ(input.at(47, 63), red);
    EXPECT_EQ(input.at(48, 0), grey);
}

TEST(Letterbox, KeepsAPixelOfALongThinImage) {
    EXPECT_EQ(Letterbox({1000, 1}, {64, 64}).content, (Size{64, 1}));
}

TEST(Letterbox, ReadsRowsWithPadding) {
    const std::vector<std::uint8_t> bytes{1, 2, 3, 9, 9, 9, 4, 5, 6, 9, 9, 9};
    const auto input = letterboxed({.bytes = bytes, .size = {1, 2}, .stride = 6}, {32, 32});
    EXPECT_EQ(input.at(0, 0), (Bgr{1, 2, 3}));
    EXPECT_EQ(input.at(0, 31), (Bgr{4, 5, 6}));
    EXPECT_EQ(input.at(31, 0), grey);
}

TEST(Letterbox, ReturnsBoxesToTheImage) {
    const Letterbox letterbox({200, 100}, {64, 64});
    EXPECT_EQ(letterbox.to_image({16, 8, 32, 24}, {200, 100}), (PixelBox{50, 25, 100, 75}));
    EXPECT_EQ(letterbox.to_image({40, 8, 60, 24}, {200, 100}), (PixelBox{125, 25, 188, 75}))
        << "farther than it is high";
    EXPECT_EQ(letterbox.to_image({-9, -9, 99, 99}, {200, 100}), (PixelBox{0, 0, 200, 100}));
    EXPECT_TRUE(letterbox.to_image({0, 40, 10, 60}, {200, 100}).empty()) << "in the padding";
}

TEST(Letterbox, HasNoBoxForWhatIsNoNumber) {
    const Letterbox letterbox({200, 100}, {64, 64});
    const double none = std::numeric_limits<double>::quiet_NaN();
    const double endless = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(letterbox.to_image({none, 0, 1, 1}, {200, 100}).empty());
    EXPECT_TRUE(letterbox.to_image({-endless, 0, endless, 1}, {200, 100}).empty());
    EXPECT_EQ(letterbox.to_image({0, 0, endless, endless}, {200, 100}), (PixelBox{0, 0, 200, 100}));
}

}  // namespace
}  // namespace vvr::detector
