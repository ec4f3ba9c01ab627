#include <gtest/gtest.h>

#include "core/image/name_pattern.h"
#include "tests/support/errors.h"

namespace vvr {
namespace {

TEST(NamePattern, FillsItsFieldWithNumbers) {
    const auto name = [](const char* pattern, std::int64_t number) {
        return image::NamePattern(pattern).at(number).string();
    };
    EXPECT_EQ(name("out.{frame:4}.png", 7), "out.0007.png");
    EXPECT_EQ(name("out.{brick:2}.png", 123), "out.123.png") << "more digits where the number has them";
    EXPECT_EQ(name("{frame}.png", 12), "12.png");
    EXPECT_EQ(name("a/b.####.png", 7), "a/b.0007.png");
    EXPECT_EQ(name("a/%04d.png", 7), "a/0007.png");
    EXPECT_EQ(name("%d.png", 7), "7.png");
}

TEST(NamePattern, SaysWhatItCounts) {
    EXPECT_EQ(image::NamePattern("{frame:4}.png").counts(), "frame");
    EXPECT_EQ(image::NamePattern("{brick:4}.png").counts(), "brick");
    EXPECT_EQ(image::NamePattern("####.png").counts(), "");
    EXPECT_TRUE(image::NamePattern("####.png").has_field());
}

TEST(NamePattern, LeavesOtherNamesAlone) {
    for (const char* plain : {"out.png", "camera#3.png", "100%.png", "##/out.png", "{frame}/out.png"}) {
        EXPECT_FALSE(image::NamePattern(plain).has_field()) << plain;
        EXPECT_EQ(image::NamePattern(plain).at(5), plain);
    }
}

std::string error_of(const char* pattern) {
    return test::error_text(ErrorKind::usage, [&] { const image::NamePattern name(pattern); });
}

TEST(NamePattern, RefusesWhatIsNoField) {
    EXPECT_EQ(error_of("a.{farme:4}.png"),
              "the field '{farme:4}' in 'a.{farme:4}.png' is unknown (did you mean 'frame'?); use {frame:4}, "
              "{brick:4}, #### or "
              "%04d");
    EXPECT_EQ(error_of("a.{frame:four}.png"),
              "the field '{frame:four}' is invalid; give 1 to 9 digits, as in {frame:4}");
    EXPECT_EQ(error_of("a.{frame:0}.png"), "the field '{frame:0}' is invalid; give 1 to 9 digits, as in {frame:4}");
    EXPECT_EQ(error_of("####.%04d.png"), "the file name '####.%04d.png' has more than one number field; use one");
    EXPECT_NE(error_of("{}.png"), "no error");
}

}  // namespace
}  // namespace vvr
