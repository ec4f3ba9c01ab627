#include <utility>

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

TEST(NamePattern, RefusesWhatIsNoField) {
    for (const auto& [bad, fact] :
         {std::pair{"a.{farme:4}.png", "'frame'"}, std::pair{"a.{frame:four}.png", "{frame:4}"},
          std::pair{"a.{frame:0}.png", "{frame:4}"}, std::pair{"####.%04d.png", "####.%04d.png"},
          std::pair{"{}.png", "{}"}}) {
        test::expect_error(ErrorCode::name_pattern_invalid, [name = bad] { const image::NamePattern pattern(name); },
                           {fact});
    }
}

}  // namespace
}  // namespace vvr
