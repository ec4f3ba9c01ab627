#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/video/clip_sampler.h"

extern "C" {
#include <libavutil/pixfmt.h>
}

namespace vvr {
namespace {

video::ScaledPicture noise(Size size, std::mt19937& random) {
    video::ScaledPicture picture{Plane<std::uint8_t>(size)};
    for (std::uint8_t& value : picture.planes.pixels()) value = static_cast<std::uint8_t>(random());
    return picture;
}

bool same(const video::ScaledPicture& a, const video::ScaledPicture& b) {
    return a.planes.size() == b.planes.size() && a.matrix == b.matrix &&
           std::ranges::equal(a.planes.pixels(), b.planes.pixels());
}

TEST(FrameStore, GivesBackWhatItTookByteForByte) {
    for (const Size size : {Size{384, 864}, Size{65, 17}, Size{33, 9}, Size{1, 1}, Size{40, 1}, Size{7, 200}}) {
        std::mt19937 random(11);
        video::FrameStore store;
        video::ScaledPicture picture{Plane<std::uint8_t>(size)};
        if (size.height % 3 == 0) picture.matrix.emplace(AVCOL_SPC_BT709, false);
        std::vector<video::ScaledPicture> wanted;
        // Nothing, then small and large differences, wrapping around at 0 and 255.
        for (const int most : {0, 1, 2, 3, 7, 8, 9, 127, 128, 255, 0, 2}) {
            std::uniform_int_distribution<int> change(-most, most);
            for (std::uint8_t& value : picture.planes.pixels()) {
                value = static_cast<std::uint8_t>(value + change(random));
            }
            ASSERT_TRUE(store.push(picture));
            wanted.push_back(picture);
        }
        for (const video::ScaledPicture& expected : wanted) {
            const auto got = store.pop();
            ASSERT_TRUE(got);
            EXPECT_TRUE(same(*got, expected)) << size.width << "x" << size.height;
        }
        EXPECT_FALSE(store.pop());
        EXPECT_EQ(store.bytes(), 0u);
    }
}

TEST(FrameStore, OneSideFillsWhileTheOtherEmpties) {
    video::FrameStore store;
    std::mt19937 random(3);
    for (int i = 0; i < 20; ++i) {
        const video::ScaledPicture picture = noise({640, 1440}, random);
        ASSERT_TRUE(store.push(picture));
        EXPECT_TRUE(same(*store.pop(), picture)) << i;
        EXPECT_EQ(store.bytes(), 0u);
    }
}

TEST(FrameStore, TakesLittleForWhatStandsStill) {
    std::mt19937 random(5);
    const video::ScaledPicture picture = noise({384, 864}, random);
    const std::size_t bytes = picture.planes.pixels().size();
    video::FrameStore store;
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(store.push(picture));
    EXPECT_GT(store.bytes(), bytes);
    EXPECT_LT(store.bytes(), 3 * bytes / 2);
}

TEST(FrameStore, LeavesOutWhatIsNotLikeTheFirst) {
    video::FrameStore store;
    const auto picture = [](Size size, std::optional<kernels::ColourMatrix> matrix = {}) {
        return video::ScaledPicture{Plane<std::uint8_t>(size), matrix};
    };
    ASSERT_TRUE(store.push(picture({32, 96})));
    EXPECT_FALSE(store.push(picture({32, 40})));
    EXPECT_FALSE(store.push(picture({32, 96}, kernels::ColourMatrix(AVCOL_SPC_BT709, false))));
    EXPECT_TRUE(store.pop());
    EXPECT_FALSE(store.pop());
}

}  // namespace
}  // namespace vvr
