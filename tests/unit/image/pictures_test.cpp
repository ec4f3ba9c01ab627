// Pictures in memory: compressed, and smaller and smaller.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/image/jpeg.h"
#include "core/image/picture.h"
#include "tests/support/planes.h"

namespace vvr {
namespace {

Plane<Bgr> chart(Size size) {
    const auto wave = [](double x) { return static_cast<std::uint8_t>(std::lround(128 + 100 * std::sin(x))); };
    return test::plane_of<Bgr>(size, [&](int i, int j) {
        return Bgr{wave(0.1 * i), wave(0.2 * j), static_cast<std::uint8_t>(i < size.width / 2 ? 255 : 0)};
    });
}

TEST(Jpeg, KeepsPictures) {
    for (const Size size : {Size{1, 1}, Size{7, 33}, Size{64, 48}, Size{416, 415}}) {
        const Plane<Bgr> picture = chart(size);
        const std::vector<std::byte> bytes = image::compress(picture);
        EXPECT_EQ(bytes, image::compress(picture));
        const Plane<Bgr> again = image::decompress(bytes);
        ASSERT_EQ(again.size(), size);
        double sum = 0;
        for (int j = 0; j < size.height; ++j) {
            for (int i = 0; i < size.width; ++i) {
                for (std::size_t c = 0; c < 3; ++c) sum += std::abs(again.at(i, j)[c] - picture.at(i, j)[c]);
            }
        }
        EXPECT_LE(sum / (3.0 * size.width * size.height), 3) << size.width << "x" << size.height;
    }
}

TEST(Jpeg, NeedsAsMuchMemoryAsItHasBytes) {
    const std::vector<std::byte> bytes = image::compress(chart({416, 416}));
    EXPECT_LE(bytes.size(), 46'000u);  // 519,168 bytes uncompressed
    EXPECT_EQ(bytes.capacity(), bytes.size());
}

TEST(Jpeg, RefusesOtherBytes) {
    EXPECT_THROW(image::decompress(std::vector<std::byte>(100)), Error);
    EXPECT_THROW(image::decompress({}), Error);
}

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
    const Plane<Bgr> picture = test::noise({8, 6}, 5);
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
