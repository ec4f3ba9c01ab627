#include "core/detector/formats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "core/detector/classes.h"

namespace vvr::detector {
namespace {

constexpr Size input{64, 64};

/// An output in which all rows but one are empty.
std::vector<float> output_with(const Format& format, int row, const std::array<float, 5>& begin, int class_id) {
    const auto length = static_cast<std::size_t>(row_length());
    std::vector<float> output(static_cast<std::size_t>(rows_of(format, input)) * length);
    const std::size_t first = static_cast<std::size_t>(row) * length;
    std::ranges::copy(begin, output.begin() + static_cast<std::ptrdiff_t>(first));
    output[first + 5 + static_cast<std::size_t>(class_id)] = 0.5F;
    return output;
}

TEST(Formats, AreKnownByTheShapeOfTheirOutput) {
    EXPECT_EQ(find_format(std::array{1, 84, 85}, input)->name, "YOLOX");
    EXPECT_EQ(find_format(std::array{1, 3549, 85}, {416, 416})->name, "YOLOX");
    EXPECT_EQ(find_format(std::array{1, 8400, 85}, {640, 640})->name, "YOLOX");
    EXPECT_EQ(find_format(std::array{1, 25200, 85}, {640, 640})->name, "YOLOv5");
    EXPECT_EQ(find_format(std::array{1, 84, 8400}, {640, 640}), nullptr);
    EXPECT_EQ(find_format(std::array{1, 84, 84}, input), nullptr);
    EXPECT_EQ(find_format(std::array{84, 85}, input), nullptr);
}

TEST(Formats, DecodeYoloxByTheCellOfARow) {
    const Format& yolox = *find_format(std::array{1, 84, 85}, input);
    // 64 cells of 8 pixels come first: row 70 is the third of the second row of 16 pixels.
    const auto output = output_with(yolox, 70, {0.5F, 0.25F, std::log(2.0F), 0, 0.8F}, 16);
    const auto candidates = decode(yolox, output, input, 0.3F);
    ASSERT_EQ(candidates.size(), 1);
    const Candidate& found = candidates.front();
    EXPECT_EQ(found.class_id, 16);
    EXPECT_FLOAT_EQ(found.score, 0.4F);
    EXPECT_NEAR(found.box.left, 40 - 16, 1e-5);
    EXPECT_NEAR(found.box.right, 40 + 16, 1e-5);
    EXPECT_NEAR(found.box.top, 20 - 8, 1e-5);
    EXPECT_NEAR(found.box.bottom, 20 + 8, 1e-5);
    EXPECT_TRUE(decode(yolox, output, input, 0.41F).empty());
}

TEST(Formats, DecodeYolov5InPixels) {
    const Format& yolov5 = *find_format(std::array{1, 252, 85}, input);
    const auto candidates = decode(yolov5, output_with(yolov5, 251, {30, 20, 10, 8, 1}, 2), input, 0.5F);
    ASSERT_EQ(candidates.size(), 1);
    EXPECT_EQ(candidates.front().box.left, 25);
    EXPECT_EQ(candidates.front().box.bottom, 24);
}

TEST(Formats, LeaveOutWhatIsNoNumber) {
    const Format& yolox = *find_format(std::array{1, 84, 85}, input);
    const float none = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(decode(yolox, output_with(yolox, 0, {0, 0, 0, 0, none}, 0), input, 0).size() < 84);
}

TEST(Classes, HaveNamesAndGroups) {
    const auto classes = object_classes();
    ASSERT_EQ(classes.size(), 80);
    EXPECT_EQ(classes[0].name, "person");
    EXPECT_EQ(classes[2].name, "car");
    EXPECT_EQ(classes[2].group, Group::vehicle);
    EXPECT_EQ(classes[16].name, "dog");
    EXPECT_EQ(classes[16].group, Group::animal);
    EXPECT_EQ(classes[24].name, "backpack");
    EXPECT_EQ(classes[24].group, Group::thing);
    EXPECT_EQ(classes[79].name, "toothbrush");
    EXPECT_EQ(name_of(Group::other), "other");
    std::set<std::string_view> names;
    for (const ObjectClass& row : classes) names.insert(row.name);
    EXPECT_EQ(names.size(), classes.size());
    EXPECT_EQ(std::ranges::count(classes, Group::person, &ObjectClass::group), 1);
    EXPECT_EQ(std::ranges::count(classes, Group::vehicle, &ObjectClass::group), 8);
    EXPECT_EQ(std::ranges::count(classes, Group::animal, &ObjectClass::group), 10);
}

}  // namespace
}  // namespace vvr::detector
