#include "core/video/pattern_set.h"

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace vvr {
namespace {

TEST(PatternSet, FindsAllThatMatchTheWholeText) {
    const std::array<std::string, 3> word_number_and_short{"[a-z]+", "[0-9]+", "[a-z]{1,4}"};
    const video::PatternSet set(word_number_and_short);
    const auto matching = [&](const char* text) {
        const std::vector<std::size_t> found = set.matching(text);
        return std::set(found.begin(), found.end());
    };
    using Indices = std::set<std::size_t>;
    EXPECT_EQ(matching("gate"), (Indices{0, 2}));
    EXPECT_EQ(matching("garden"), (Indices{0}));
    EXPECT_EQ(matching("42"), (Indices{1}));
    EXPECT_EQ(matching("gate 42"), Indices{});
    EXPECT_EQ(matching(""), Indices{});
}

}  // namespace
}  // namespace vvr
