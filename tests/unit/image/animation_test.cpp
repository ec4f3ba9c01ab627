#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <unistd.h>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/image/picture.h"
#include "core/image/video_encoder.h"
#include "core/video/frame_source.h"
#include "core/video/scaler.h"

namespace vvr {
namespace {

namespace fs = std::filesystem;

constexpr Size size{64, 48};
constexpr int pictures = 6;

/// A grey background with a bar of red that moves.
image::Picture bar_at(int place) {
    image::Picture picture{Plane<image::Rgba>(size, {0.5F, 0.5F, 0.5F, 1})};
    for (int j = 0; j < size.height; ++j) {
        for (int i = 8 * place; i < 8 * place + 8; ++i) picture.pixels.at(i, j) = {1, 0, 0, 1};
    }
    return picture;
}

class AnimationTest : public testing::TestWithParam<std::string> {
  protected:
    AnimationTest() : folder_(fs::temp_directory_path() / ("vvr-animation-" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~AnimationTest() override { fs::remove_all(folder_); }
    AnimationTest(const AnimationTest&) = delete;
    AnimationTest& operator=(const AnimationTest&) = delete;

    fs::path file(const std::string& name) const { return folder_ / name; }

    static void write(const fs::path& path) {
        image::AnimationFile animation(path, 20);
        for (int i = 0; i < pictures; ++i) animation.add(bar_at(i));
        animation.close();
    }

    static std::string bytes(const fs::path& path) {
        std::ifstream stream(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }

  private:
    fs::path folder_;
};

TEST_P(AnimationTest, HoldsThePicturesInOrder) {
    const fs::path path = file("moving" + GetParam());
    write(path);
    video::SourceOptions options;
    options.field_size = size;
    options.colour = true;
    const auto source = video::open_source(path.string(), options);
    EXPECT_EQ(source->info().size, size);
    video::Scaler scaler(*source);
    int count = 0;
    for (auto decoded = source->next(); decoded; decoded = source->next(), ++count) {
        const video::Frame frame = scaler(*decoded);
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
    write(file("a" + GetParam()));
    write(file("b" + GetParam()));
    EXPECT_FALSE(bytes(file("a" + GetParam())).empty());
    EXPECT_EQ(bytes(file("a" + GetParam())), bytes(file("b" + GetParam())));
}

TEST_P(AnimationTest, LeavesNothingUnlessItIsClosed) {
    {
        image::AnimationFile animation(file("a" + GetParam()), 20);
        animation.add(bar_at(0));
    }
    EXPECT_EQ(files(), 0);
}

INSTANTIATE_TEST_SUITE_P(Endings, AnimationTest, testing::ValuesIn(image::animation_extensions()),
                         [](const auto& tested) { return tested.param.substr(1); });

TEST(Animation, KnowsItsEndings) {
    EXPECT_TRUE(image::is_animation("a.GIF"));
    EXPECT_FALSE(image::is_animation("a.png"));
    EXPECT_THROW(image::AnimationFile("a.png", 20), Error);
}

TEST(Animation, OfOddSizesLosesALineInVideo) {
    const fs::path path = fs::temp_directory_path() / ("vvr-odd-" + std::to_string(::getpid()) + ".mp4");
    image::AnimationFile animation(path, 20);
    animation.add(image::Picture{Plane<image::Rgba>({33, 17}, {1, 1, 1, 1})});
    animation.close();
    EXPECT_EQ(video::open_source(path.string(), {})->info().size, (Size{32, 16}));
    fs::remove(path);
}

TEST(Palette, KeepsFewColoursExactly) {
    const image::Picture picture = bar_at(2);
    image::Palette palette(picture);
    ASSERT_EQ(palette.colours().size(), 2U);
    EXPECT_EQ(palette.colours()[palette.nearest({1, 0, 0, 1})], (image::Palette::Colour{255, 0, 0}));
    EXPECT_EQ(palette.colours()[palette.nearest({0.5F, 0.5F, 0.5F, 1})], (image::Palette::Colour{128, 128, 128}));
}

TEST(Palette, IsNearToManyColours) {
    image::Picture picture{Plane<image::Rgba>({256, 256}, {0, 0, 0, 1})};
    for (int j = 0; j < 256; ++j) {
        for (int i = 0; i < 256; ++i) {
            picture.pixels.at(i, j) = {static_cast<float>(i) / 255, static_cast<float>(j) / 255, 0.5F, 1};
        }
    }
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
