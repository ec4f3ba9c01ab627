#include "core/image/jpeg.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace vvr {
namespace {

Plane<Bgr> chart(Size size) {
    Plane<Bgr> picture(size);
    for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i) {
            const auto wave = [](double x) { return static_cast<std::uint8_t>(std::lround(128 + 100 * std::sin(x))); };
            picture.at(i, j) = {wave(0.1 * i), wave(0.2 * j), static_cast<std::uint8_t>(i < size.width / 2 ? 255 : 0)};
        }
    }
    return picture;
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
    EXPECT_LE(image::compress(chart({416, 416})).size(), 40'000u);
}

TEST(Jpeg, RefusesOtherBytes) {
    EXPECT_THROW(image::decompress(std::vector<std::byte>(100)), Error);
    EXPECT_THROW(image::decompress({}), Error);
}

}  // namespace
}  // namespace vvr
