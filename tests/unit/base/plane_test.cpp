#include "core/base/plane.h"

#include <cstdint>

#include <gtest/gtest.h>

namespace vvr {
namespace {

Plane<std::uint8_t> numbered(Size size) {
    Plane<std::uint8_t> plane(size);
    std::uint8_t next = 0;
    for (std::uint8_t& value : plane.pixels()) value = next++;
    return plane;
}

TEST(Plane, IsCroppedToABox) {
    const Plane<std::uint8_t> plane = numbered({5, 4});
    const PixelBox box{1, 2, 4, 4};
    const Plane<std::uint8_t> part = cropped(plane, box);
    ASSERT_EQ(part.size(), (Size{3, 2}));
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 3; ++i) EXPECT_EQ(part.at(i, j), plane.at(1 + i, 2 + j)) << i << ", " << j;
    }
    EXPECT_TRUE(cropped(plane, {2, 2, 2, 2}).empty());
}

TEST(Plane, IsFilledOnlyWhereItIs) {
    for (const PixelBox& box : {PixelBox{1, 1, 3, 2}, PixelBox{-3, -1, 2, 9}, PixelBox{4, 3, 50, 60},
                                PixelBox{9, 0, 12, 4}, PixelBox{0, -8, 5, -2}, PixelBox{3, 3, 3, 4}}) {
        const Plane<std::uint8_t> before = numbered({5, 4});
        Plane<std::uint8_t> plane = before;
        fill(plane, box, 99);
        for (int j = 0; j < plane.height(); ++j) {
            for (int i = 0; i < plane.width(); ++i) {
                const bool inside = i >= box.left && i < box.right && j >= box.top && j < box.bottom;
                EXPECT_EQ(plane.at(i, j), inside ? 99 : before.at(i, j)) << i << ", " << j;
            }
        }
    }
}

}  // namespace
}  // namespace vvr
