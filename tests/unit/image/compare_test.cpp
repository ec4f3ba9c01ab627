#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/image/comparison.h"
#include "core/image/picture_file.h"

namespace vvr {
namespace {

image::Samples even(Size size, float value, std::vector<std::string> channels = {"R", "G", "B"}) {
    image::Samples samples{size, std::move(channels), {}};
    samples.values.assign(static_cast<std::size_t>(size.width * size.height) * samples.channels.size(), value);
    return samples;
}

float& value_at(image::Samples& samples, int i, int j, std::size_t channel) {
    return samples.values[(static_cast<std::size_t>(j * samples.size.width + i)) * samples.channels.size() + channel];
}

TEST(Compare, EqualPicturesAreTheSame) {
    const image::Samples a = even({20, 10}, 0.5F);
    const image::Comparison comparison = image::compare(a, a, {0, 0, 0});
    EXPECT_EQ(comparison.verdict, image::Verdict::same);
    EXPECT_EQ(comparison.max, 0);
    EXPECT_TRUE(std::isinf(comparison.psnr));
    EXPECT_TRUE(comparison.worst.empty());
    EXPECT_TRUE(comparison.reason.empty());
}

TEST(Compare, NumbersAreWhatTheyAreCalled) {
    const image::Samples a = even({10, 10}, 0.25F);
    image::Samples b = a;
    value_at(b, 7, 3, 1) = 0.75F;
    value_at(b, 2, 9, 0) = 0.35F;
    const image::Comparison comparison = image::compare(a, b, {0.2, 1, 1});
    EXPECT_NEAR(comparison.mean, 0.6 / 300, 1e-8);
    EXPECT_NEAR(comparison.max, 0.5, 1e-8);
    EXPECT_NEAR(comparison.rms, std::sqrt(0.26 / 300), 1e-8);
    EXPECT_NEAR(comparison.psnr, 10 * std::log10(300 / 0.26), 1e-5);
    EXPECT_EQ(comparison.off, 1);
    EXPECT_DOUBLE_EQ(comparison.percent, 1);
    EXPECT_EQ(comparison.verdict, image::Verdict::same) << "1 % may be off";
    ASSERT_EQ(comparison.worst.size(), 2U);
    EXPECT_EQ(comparison.worst[0].column, 7);
    EXPECT_EQ(comparison.worst[0].row, 3);
    EXPECT_EQ(comparison.worst[0].a, (std::vector{0.25F, 0.25F, 0.25F}));
    EXPECT_EQ(comparison.worst[0].b, (std::vector{0.25F, 0.75F, 0.25F}));
    EXPECT_EQ(comparison.worst[1].column, 2);
    EXPECT_EQ(image::compare(a, b, {0.05, 1, 1}).verdict, image::Verdict::values);
}

TEST(Compare, SizeChannelsAndNumbersComeFirstInThatOrder) {
    image::Samples a = even({4, 4}, 0.5F);
    image::Samples b = even({4, 5}, 0.5F, {"R", "G", "B", "A"});
    value_at(b, 1, 2, 0) = std::numeric_limits<float>::quiet_NaN();
    image::Comparison comparison = image::compare(a, b);
    EXPECT_EQ(comparison.verdict, image::Verdict::size);
    EXPECT_NE(comparison.reason.find("4x4 and 4x5"), std::string::npos);
    EXPECT_FALSE(comparison.has_numbers());
    b.size = {4, 4};
    b.values.resize(64);
    comparison = image::compare(a, b);
    EXPECT_EQ(comparison.verdict, image::Verdict::channels);
    EXPECT_NE(comparison.reason.find("R,G,B and R,G,B,A"), std::string::npos);
    comparison = image::compare(even({4, 4}, 0.5F, {"R", "G", "B", "A"}), b);
    EXPECT_EQ(comparison.verdict, image::Verdict::not_finite);
    EXPECT_EQ(comparison.reason, "1 value of the second picture is not finite, first at 1,2");
    EXPECT_EQ(image::compare(b, b).verdict, image::Verdict::not_finite) << "in both alike is no better";
}

TEST(Compare, APatchThatChangedIsSeenWhereverItIs) {
    const image::Samples a = even({200, 100}, 0.5F);
    for (const int left : {0, 3, 4, 61, 192}) {
        image::Samples b = a;
        for (int j = 41; j < 47; ++j) {
            for (int i = left; i < left + 6; ++i) value_at(b, i, j, 2) = 0.7F;
        }
        const image::Comparison comparison = image::compare(a, b);
        EXPECT_LT(comparison.percent, 0.2);
        EXPECT_EQ(comparison.verdict, image::Verdict::values) << left;
        EXPECT_NE(comparison.reason.find("a patch of 8x8 pixels"), std::string::npos) << comparison.reason;
    }
}

TEST(Compare, ScatteredPixelsAndRoundingAreAllowed) {
    const image::Samples a = even({200, 100}, 0.5F);
    image::Samples b = even({200, 100}, 0.5F + 2.0F / 255);
    for (int k = 0; k < 100; ++k) value_at(b, (k * 37) % 200, k, 1) = 1;
    EXPECT_EQ(image::compare(a, b).verdict, image::Verdict::same) << image::compare(a, b).reason;
}

TEST(DifferenceLetters, StandWhereTheDifferenceIs) {
    Plane<float> pixels({120, 80});
    pixels.at(119, 79) = 1;
    pixels.at(0, 0) = 0.02F;
    pixels.at(60, 0) = 0.01F;
    const std::string text = image::difference_letters(pixels, 0.015);
    std::vector<std::string> lines;
    for (std::size_t from = 0; from < text.size(); from = text.find('\n', from) + 1) {
        lines.push_back(text.substr(from, text.find('\n', from) - from));
    }
    ASSERT_EQ(lines.size(), 22U);
    for (const std::string& line : lines) EXPECT_EQ(line.size(), 62U);
    EXPECT_EQ(lines[1], "|:" + std::string(59, ' ') + "|");
    EXPECT_EQ(lines[20], "|" + std::string(59, ' ') + "@|");
}

TEST(DifferencePicture, ColoursWhatDiffersAndPalesTheRest) {
    const image::Samples a = even({16, 16}, 0.0F);
    image::Samples b = a;
    value_at(b, 5, 6, 0) = 1;
    value_at(b, 6, 6, 0) = 0.01F;
    const image::Picture picture = image::difference_picture(a, image::compare(a, b));
    EXPECT_EQ(picture.pixels.at(5, 6), (image::Rgba{0, 0, 0, 1}));
    EXPECT_GT(picture.pixels.at(6, 6)[0] - picture.pixels.at(6, 6)[2], 0.5F);
    EXPECT_EQ(picture.pixels.at(0, 0), (image::Rgba{0.7F, 0.7F, 0.7F, 1}));
}

}  // namespace
}  // namespace vvr
