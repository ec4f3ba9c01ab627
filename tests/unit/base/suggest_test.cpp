#include <array>
#include <string>

#include <gtest/gtest.h>

#include "core/base/setting.h"

namespace vvr {
namespace {

const std::array<std::string, 4> names{"render", "info", "doctor", "horn-schunck"};

TEST(SuggestTest, CountsEdits) {
    EXPECT_EQ(edit_distance("", "abc"), 3U);
    EXPECT_EQ(edit_distance("render", "render"), 0U);
    EXPECT_EQ(edit_distance("redner", "render"), 1U);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(SuggestTest, FindsTheNearestName) {
    EXPECT_EQ(nearest_name("redner", names), "render");
    EXPECT_EQ(nearest_name("doc", names), "doctor");
    EXPECT_EQ(nearest_name("horn", names), "horn-schunck");
    EXPECT_EQ(nearest_name("xyzzy", names), "");
    EXPECT_EQ(nearest_name("", names), "");
}

TEST(SuggestTest, Asks) {
    EXPECT_EQ(did_you_mean("inof", names), " (did you mean 'info'?)");
    EXPECT_EQ(did_you_mean("xyzzy", names), "");
}

}  // namespace
}  // namespace vvr
