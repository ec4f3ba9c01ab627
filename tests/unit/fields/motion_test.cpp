#include "core/fields/motion.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/planes.h"

namespace vvr {
namespace {

/// Whether something moves in each of so many frames, ten per second: a block that moves from `begin` to `end` and then
/// lies where it is, and noise.
std::vector<bool> motion(int frames, int begin, int end) {
    fields::MotionDetector moves;
    std::vector<bool> told;
    int place = 0;
    for (int i = 0; i < frames; ++i) {
        place = (place + (begin <= i && i < end ? 2 : 0)) % 48;
        fields::Field field{i, 0.1 * i, Plane<std::uint8_t>({64, 32}), {}, {}};
        fill(field.scalar, {place, 8, place + 16, 24}, 200);
        field.scalar.at(i % 64, 3) = 90;
        told.push_back(moves(field));
    }
    return told;
}

TEST(MotionDetector, IsToldForAsLongAsSomethingMovesAndASecondMore) {
    const std::vector<bool> told = motion(200, 50, 90);
    for (int i = 0; i < 200; ++i) {
        const bool moves = told[static_cast<std::size_t>(i)];
        EXPECT_FALSE(moves && (i < 50 || i >= 106)) << i;
        EXPECT_TRUE(moves || i < 54 || i >= 99) << i;
    }
}

TEST(MotionDetector, IsNoneOfWhatLiesThere) {
    for (const bool moves : motion(100, 0, 0)) EXPECT_FALSE(moves);
}

}  // namespace
}  // namespace vvr
