#include "cli/console.h"

#include <gtest/gtest.h>

namespace vvr {
namespace {

TEST(Progress, TellsPercentAndTheTimeThatIsLeft) {
    EXPECT_EQ(cli::progress_text("frames", 50, 200, 4), "frames [=====               ] 25 %, 12 s left");
    EXPECT_EQ(cli::progress_text("frames", 50, 200, 1), "frames [=====               ] 25 %") << "too early";
    EXPECT_EQ(cli::progress_text("frames", 250, 200, 9), "frames [====================] 100 %") << "a wrong header";
    EXPECT_EQ(cli::progress_text("frames", 50, 0, 4), "frames 50") << "an unknown length";
}

}  // namespace
}  // namespace vvr
