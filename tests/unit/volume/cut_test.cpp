#include <vector>

#include <gtest/gtest.h>

#include "core/volume/brick.h"
#include "core/volume/volume.h"

namespace vvr {
namespace {

TEST(Cut, IntoBricksCoversEachLayerOnce) {
    for (const std::int64_t layers : {1, 2, 7, 795, 800}) {
        for (const int k : {1, 2, 8, 32}) {
            std::int64_t next = 0;
            for (const volume::Brick& brick : volume::cut_into(layers, k)) {
                EXPECT_EQ(brick.first, next);
                EXPECT_GE(brick.count, 1);
                next += brick.count;
            }
            EXPECT_EQ(next, layers);
        }
    }
}

TEST(Cut, ByLengthLeavesTheRestToTheLast) {
    EXPECT_EQ(volume::cut_by(7, 3), (std::vector<volume::Brick>{{0, 3}, {3, 3}, {6, 1}}));
    EXPECT_TRUE(volume::cut_by(0, 3).empty());
}

TEST(Cut, AtLayersLeavesNoBrickEmpty) {
    const std::vector<volume::Brick> whole{{0, 4}, {4, 4}};
    EXPECT_EQ(volume::cut_at(whole, std::vector<std::int64_t>{0, 2, 4, 5, 8}),
              (std::vector<volume::Brick>{{0, 2}, {2, 2}, {4, 1}, {5, 3}}));
}

TEST(Cut, IntoPiecesStaysWithinBricks) {
    EXPECT_EQ(volume::cut_into_sub_bricks(std::vector<volume::Brick>{{0, 32}, {32, 33}, {65, 100}}),
              (std::vector<volume::Brick>{{0, 32}, {32, 16}, {48, 17}, {65, 25}, {90, 25}, {115, 25}, {140, 25}}));
    EXPECT_EQ(volume::cut_into_sub_bricks(std::vector<volume::Brick>{{7, 1}}), (std::vector<volume::Brick>{{7, 1}}));
    EXPECT_TRUE(volume::cut_into_sub_bricks(std::vector<volume::Brick>{}).empty());
}

}  // namespace
}  // namespace vvr
