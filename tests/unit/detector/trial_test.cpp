#include <csignal>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "core/detector/detector.h"

namespace vvr::detector {
namespace {

TEST(Trial, SucceedsWithoutAWordAndChangesNothingInTheParent) {
    int value = 1;
    EXPECT_EQ(failure_in_child([&] { value = 2; }), std::nullopt);
    EXPECT_EQ(value, 1);
}

TEST(Trial, SaysWhatTheActionThrew) {
    EXPECT_EQ(failure_in_child([] { throw std::runtime_error("it is odd"); }), "it is odd");
}

TEST(Trial, SurvivesACrash) {
    for (const int number : {SIGSEGV, SIGFPE}) {
        const auto failure = failure_in_child([number] { ::raise(number); });
        ASSERT_TRUE(failure);
        EXPECT_TRUE(failure->ends_with(std::to_string(number))) << *failure;
    }
}

TEST(Trial, SurvivesAnExit) {
    EXPECT_TRUE(failure_in_child([] { ::_exit(0); }));
}

TEST(Trial, EndsWhatComputesForEver) {
    const auto spin = [] {
        volatile bool forever = true;
        while (forever) {
        }
    };
    EXPECT_TRUE(failure_in_child(spin, {.seconds = 1}));
}

TEST(Trial, EndsWhatWaitsForEver) {
    const auto wait = [] {
        while (true) ::pause();
    };
    EXPECT_TRUE(failure_in_child(wait, {.clock_seconds = 1}));
}

#ifndef __SANITIZE_ADDRESS__
TEST(Trial, EndsWhatNeedsTooMuchMemory) {
    const auto fill = [] { std::vector<char>(std::size_t{1} << 30U).back() = 1; };
    EXPECT_TRUE(failure_in_child(fill, {.megabytes = 100}));
}
#endif

}  // namespace
}  // namespace vvr::detector
