#include <csignal>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "core/detector/detector.h"

namespace vvr::detector {
namespace {

TEST(Trial, SucceedsWithoutAWord) {
    EXPECT_EQ(failure_in_child([] {}), std::nullopt);
}

TEST(Trial, ChangesNothingInTheParent) {
    int value = 1;
    EXPECT_EQ(failure_in_child([&] { value = 2; }), std::nullopt);
    EXPECT_EQ(value, 1);
}

TEST(Trial, SaysWhatTheActionThrew) {
    EXPECT_EQ(failure_in_child([] { throw std::runtime_error("it is odd"); }), "it is odd");
}

TEST(Trial, SurvivesACrash) {
    EXPECT_EQ(failure_in_child([] { ::raise(SIGSEGV); }), "it crashes OpenCV with signal 11");
    EXPECT_EQ(failure_in_child([] { ::raise(SIGFPE); }), "it crashes OpenCV with signal 8");
}

TEST(Trial, SurvivesAnExit) {
    EXPECT_EQ(failure_in_child([] { ::_exit(0); }), "it ends the program");
}

TEST(Trial, EndsWhatComputesForEver) {
    const auto spin = [] {
        volatile bool forever = true;
        while (forever) {
        }
    };
    EXPECT_EQ(failure_in_child(spin, {.seconds = 1}), "it needs more than 1 s for one image");
}

TEST(Trial, EndsWhatWaitsForEver) {
    const auto wait = [] {
        while (true) ::pause();
    };
    EXPECT_EQ(failure_in_child(wait, {.clock_seconds = 1}), "it hangs: no answer for 1 s");
}

#ifndef __SANITIZE_ADDRESS__
TEST(Trial, EndsWhatNeedsTooMuchMemory) {
    const auto fill = [] { std::vector<char>(std::size_t{1} << 30U).back() = 1; };
    EXPECT_EQ(failure_in_child(fill, {.megabytes = 100}), "it needs too much memory");
}
#endif

}  // namespace
}  // namespace vvr::detector
