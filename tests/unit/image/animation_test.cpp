#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/footage/open_source.h"
#include "core/image/picture.h"
#include "core/image/video_encoder.h"
#include "core/media/frame_source.h"
#include "core/media/scaler.h"
#include "tests/support/planes.h"
#include "tests/support/temp_folder.h"

namespace vvr {
namespace {

constexpr Size size{64, 48};
constexpr int pictures = 6;

/// A grey background with a bar of red that moves.
image::Picture bar_at(int place) {
    image::Picture picture{Plane<image::Rgba>(size, {0.5F, 0.5F, 0.5F, 1})};
    fill(picture.pixels, {8 * place, 0, 8 * place + 8, size.height}, {1, 0, 0, 1});
    return picture;
}

class AnimationTest : public testing::TestWithParam<std::string> {
  protected:
    static void write(const std::string& path) {
        image::AnimationFile animation(path, 20);
        for (int i = 0; i < pictures; ++i) animation.add(bar_at(i));
        animation.close();
    }

    test::TempFolder folder;
};

TEST_P(AnimationTest, HoldsThePicturesInOrder) {
    const std::string path = folder / ("moving" + GetParam());
    write(path);
    media::SourceOptions options{.field_size = size, .colour = true};
    const auto source = footage::open_source(path, options);
    EXPECT_EQ(source->info().size, size);
    media::Scaler scaler(*source);
    int count = 0;
    for (auto decoded = source->next(); decoded; decoded = source->next(), ++count) {
        const media::Frame frame = scaler(*decoded);
        EXPECT_NEAR(frame.pts, 0.05 * count, 1e-3);
        const Bgr bar = frame.colour.at(8 * count + 4, 20);
        EXPECT_GT(bar[2], 230) << "picture " << count;
        EXPECT_LT(bar[1], 40);
        const Bgr beside = frame.colour.at(8 * ((count + 3) % 8) + 4, 20);
        for (const std::uint8_t value : beside) EXPECT_NEAR(value, 128, 6);
    }
    EXPECT_EQ(count, pictures);
}

TEST_P(AnimationTest, IsTheSameBytesAgain) {
    write(folder / ("a" + GetParam()));
    write(folder / ("b" + GetParam()));
    const std::string bytes = test::read_bytes(folder / ("a" + GetParam()));
    EXPECT_FALSE(bytes.empty());
    EXPECT_EQ(bytes, test::read_bytes(folder / ("b" + GetParam())));
}

TEST_P(AnimationTest, LeavesNothingUnlessItIsClosed) {
    {
        image::AnimationFile animation(folder / ("a" + GetParam()), 20);
        animation.add(bar_at(0));
    }
    EXPECT_EQ(folder.files(), 0);
}

INSTANTIATE_TEST_SUITE_P(Endings, AnimationTest, testing::ValuesIn(image::animation_extensions()),
                         [](const auto& tested) { return tested.param.substr(1); });

TEST(Animation, KnowsItsEndings) {
    EXPECT_TRUE(image::is_animation("a.GIF"));
    EXPECT_FALSE(image::is_animation("a.png"));
    EXPECT_THROW(image::AnimationFile("a.png", 20), Error);
}

TEST(Animation, OfOddSizesLosesALineInVideo) {
    const test::TempFolder folder;
    const std::string path = folder / "odd.mp4";
    image::AnimationFile animation(path, 20);
    animation.add(image::Picture{Plane<image::Rgba>({33, 17}, {1, 1, 1, 1})});
    animation.close();
    EXPECT_EQ(footage::open_source(path, {})->info().size, (Size{32, 16}));
}

TEST(Palette, KeepsFewColoursExactly) {
    const image::Picture picture = bar_at(2);
    image::Palette palette(picture);
    ASSERT_EQ(palette.colours().size(), 2U);
    EXPECT_EQ(palette.colours()[palette.nearest({1, 0, 0, 1})], (image::Palette::Colour{255, 0, 0}));
    EXPECT_EQ(palette.colours()[palette.nearest({0.5F, 0.5F, 0.5F, 1})], (image::Palette::Colour{128, 128, 128}));
}

TEST(Palette, IsNearToManyColours) {
    const image::Picture picture{test::plane_of<image::Rgba>({256, 256}, [](int i, int j) {
        return image::Rgba{static_cast<float>(i) / 255, static_cast<float>(j) / 255, 0.5F, 1};
    })};
    image::Palette palette(picture);
    EXPECT_EQ(palette.colours().size(), 256U);
    double worst = 0;
    for (const image::Rgba& pixel : picture.pixels.pixels()) {
        const image::Palette::Colour& colour = palette.colours()[palette.nearest(pixel)];
        for (int c = 0; c < 3; ++c) {
            const int level = colour[static_cast<std::size_t>(c)];
            worst = std::max(worst, std::abs(level - 255.0 * static_cast<double>(pixel[c])));
        }
    }
    EXPECT_LT(worst, 24) << "256 colours over a square of 256 by 256: 16 apart";
}

}  // namespace
}  // namespace vvr
