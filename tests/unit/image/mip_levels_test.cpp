#include <random>

#include <gtest/gtest.h>

#include "core/image/picture.h"

namespace vvr {
namespace {

template <class T>
std::vector<Size> sizes_of(const std::vector<Plane<T>>& levels) {
    std::vector<Size> sizes;
    for (const Plane<T>& level : levels) sizes.push_back(level.size());
    return sizes;
}

TEST(MipLevels, HalveDownToAPixel) {
    EXPECT_EQ(sizes_of(image::mip_levels(Plane<std::uint8_t>({384, 97}))),
              (std::vector<Size>{{192, 48}, {96, 24}, {48, 12}, {24, 6}, {12, 3}, {6, 1}, {3, 1}, {1, 1}}));
    EXPECT_EQ(sizes_of(image::mip_levels(Plane<Bgr>({64, 1}))),
              (std::vector<Size>{{32, 1}, {16, 1}, {8, 1}, {4, 1}, {2, 1}, {1, 1}}));
    EXPECT_TRUE(image::mip_levels(Plane<Bgr>({1, 1})).empty());
}

TEST(MipLevels, AreTheMeansOfWhatTheyCover) {
    std::mt19937 random(5);
    Plane<Bgr> picture({8, 6});
    for (Bgr& pixel : picture.pixels()) {
        for (std::uint8_t& value : pixel) value = static_cast<std::uint8_t>(random());
    }
    const Plane<Bgr> half = image::mip_levels(picture).front();
    for (int j = 0; j < half.height(); ++j) {
        for (int i = 0; i < half.width(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                const int sum = picture.at(2 * i, 2 * j)[c] + picture.at(2 * i + 1, 2 * j)[c] +
                                picture.at(2 * i, 2 * j + 1)[c] + picture.at(2 * i + 1, 2 * j + 1)[c];
                EXPECT_NEAR(half.at(i, j)[c], sum / 4.0, 0.51);
            }
        }
    }
}

TEST(MipLevels, LeaveOutNoColumnOfAnOddWidth) {
    Plane<std::uint8_t> picture({5, 1});
    picture.at(4, 0) = 250;
    EXPECT_EQ(image::mip_levels(picture).front().at(1, 0), 100) << "the mean of two pixels and a half";
}

}  // namespace
}  // namespace vvr
