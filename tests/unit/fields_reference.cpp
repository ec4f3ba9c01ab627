#include <vector>

#include <gtest/gtest.h>

#include "core/fields/reference.h"
#include "tests/unit/fields_pictures.h"

namespace vvr {
namespace {

TEST(Reference, MedianForgetsWhoPassedBy) {
    std::vector<Frame> frames;
    for (int f = 0; f < 9; ++f) {
        frames.push_back(test::texture_frame({40, 7}, 0, 0, 0));
        frames.back().grey.at(4 * f, 3) = 255;
        frames.back().grey.at(4 * f + 1, 3) = 0;
    }
    const Reference reference = median_reference(frames);
    const Frame empty = test::texture_frame({40, 7}, 0, 0, 0);
    EXPECT_TRUE(std::ranges::equal(reference.grey.pixels(), empty.grey.pixels()));
    EXPECT_TRUE(reference.colour.empty());
}

TEST(Reference, MedianIsTheMiddleValue) {
    std::vector<Frame> frames;
    for (int level : {200, 3, 77, 255, 0})
        frames.push_back(test::flat_frame({3, 2}, 0, static_cast<std::uint8_t>(level)));
    EXPECT_EQ(median_reference(frames).grey.at(2, 1), 77);
    frames.pop_back();
    EXPECT_EQ(median_reference(frames).grey.at(2, 1), 200) << "of four, the upper of the two in the middle";
    frames.resize(1);
    EXPECT_EQ(median_reference(frames).grey.at(2, 1), 200);
}

TEST(Reference, MedianTakesEachChannelByItself) {
    std::vector<Frame> frames;
    for (const Bgr& colour : {Bgr{10, 50, 90}, Bgr{20, 60, 70}, Bgr{30, 40, 80}}) {
        frames.push_back(test::flat_frame({5, 4}, 0, 9));
        frames.back().colour = Plane<Bgr>({5, 4}, colour);
    }
    EXPECT_EQ(median_reference(frames).colour.at(4, 3), (Bgr{20, 50, 80}));
}

TEST(Reference, NoFramesNoReference) {
    EXPECT_TRUE(median_reference({}).empty());
}

}  // namespace
}  // namespace vvr
