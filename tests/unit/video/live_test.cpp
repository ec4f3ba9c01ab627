#include <gtest/gtest.h>

#include "core/video/live_source.h"

namespace vvr {
namespace {

TEST(LiveClock, FollowsTheStampsOfOneConnection) {
    video::LiveClock clock(0.04);
    EXPECT_EQ(clock(100.0, 5), 0);
    EXPECT_NEAR(clock(100.04, 9), 0.04, 1e-9);  // late, and yet taken 40 ms after the other
    EXPECT_NEAR(clock(103.0, 9.01), 3.0, 1e-9);
    EXPECT_NEAR(clock(std::nullopt, 9.02), 3.04, 1e-9);
}

TEST(LiveClock, GoesByTheReadersClockWhereStampsSayNothing) {
    video::LiveClock clock(0.04);
    clock(100.0, 0);
    clock(100.04, 0.04);
    clock.restart();
    EXPECT_NEAR(clock(7.0, 12.04), 12.04, 1e-9);  // another connection, 12 s later
    EXPECT_NEAR(clock(7.04, 12.08), 12.08, 1e-9);
    EXPECT_NEAR(clock(2.0, 12.12), 12.12, 1e-9);   // the camera's clock went back
    EXPECT_NEAR(clock(5000.0, 12.2), 12.2, 1e-9);  // and far ahead
    EXPECT_NEAR(clock(5000.04, 12.24), 12.24, 1e-9);
}

TEST(LiveClock, NeverRunsBackwards) {
    video::LiveClock clock(0.04);
    double last = -1;
    for (const double stamp : {3.0, 3.04, 3.02, 3.08, -50.0, 1e9, 2.0, 2.04}) {
        const double time = clock(stamp, 0);  // all at once
        EXPECT_GT(time, last) << stamp;
        last = time;
    }
}

}  // namespace
}  // namespace vvr
