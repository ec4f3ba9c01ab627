#include "core/image/text.h"

#include <string>

#include <gtest/gtest.h>

namespace vvr {
namespace {

constexpr int letter_size = 40;

int width_of(const std::string& text) {
    const std::optional<PixelBox> box = image::measure_text(text, letter_size);
    return box ? box->width() : 0;
}

/// The rows that a text covers between two columns.
int height_between(const image::Picture& picture, int left, int right) {
    int rows = 0;
    for (int j = 0; j < picture.pixels.height(); ++j) {
        bool covers = false;
        for (int i = left; i < right; ++i) covers = covers || picture.pixels.at(i, j).a > 0.5F;
        rows += covers ? 1 : 0;
    }
    return rows;
}

TEST(Text, AnArabicWordIsJoinedAndRunsFromRightToLeft) {
    const std::string beh = "\u0628";
    const std::string alef = "\u0627";
    ASSERT_TRUE(image::missing_characters(beh + alef).empty()) << "the fonts have no Arabic letters";
    EXPECT_LT(width_of(beh + beh + beh), 2 * width_of(beh)) << "the letters are not joined";

    image::Picture picture{Plane<image::Rgba>({200, 100}, image::Rgba(0))};
    ASSERT_TRUE(image::draw_text(picture, 50, 60, alef + beh, letter_size, image::Rgba(1)));
    const PixelBox box = *image::measure_text(alef + beh, letter_size);
    const int middle = 50 + (box.left + box.right) / 2;
    EXPECT_GT(height_between(picture, middle, 200), height_between(picture, 0, middle))
        << "the tall alef is not at the right";
}

TEST(Text, MissingCharactersAreThoseOfNoFont) {
    const std::string unassigned = "\U000EFFFD";
    EXPECT_EQ(image::missing_characters("gate " + unassigned + unassigned), std::set<std::string>{unassigned});
    EXPECT_TRUE(image::missing_characters("a\u200B\u202Ab \uFE0F").empty()) << "invisible characters need no font";
    EXPECT_TRUE(image::missing_characters("a\xFFz").empty()) << "what is not UTF-8 is drawn as '?'";
}

TEST(Text, EmptyTextHasNoBox) {
    EXPECT_FALSE(image::measure_text("", letter_size));
}

}  // namespace
}  // namespace vvr
