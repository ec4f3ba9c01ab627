#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

#include <gtest/gtest.h>

extern "C" {
#include <libavutil/frame.h>
}

#include "core/footage/open_source.h"
#include "core/media/scaler.h"
#include "tests/support/planes.h"
#include "tests/unit/media/clips.h"

namespace vvr {
namespace {

using namespace test;

/// Left half red, right half a grey ramp from top to bottom.
void write_chart(const std::string& name, Size size) {
    const auto paint = [size](int) {
        return plane_of<Bgr>(size, [size](int i, int j) {
            const auto grey = static_cast<std::uint8_t>(255 * j / (size.height - 1));
            return i < size.width / 2 ? Bgr{30, 40, 200} : Bgr{grey, grey, grey};
        });
    };
    write_painted(size, 2, paint, name);
}

class PixelFormats : public testing::TestWithParam<std::string> {};

TEST_P(PixelFormats, GiveTheSameGreyAndColour) {
    const TempFolder folder;
    write_chart(folder / "chart.y4m", {64, 64});
    const std::string format = GetParam();
    const std::string codec = format.starts_with("yuvj") ? "mjpeg -q:v 1" : format == "nv12" ? "rawvideo" : "ffv1";
    // Formats that ffv1 doesn't hold go into pictures.
    const bool is_picture = format == "pal8" || format == "rgb24" || format == "rgba" || format == "rgb48be";
    const auto name = is_picture ? folder / "c%d.png" : folder / "chart.nut";
    ffmpeg("-i " + quoted(folder / "chart.y4m") + (is_picture ? "" : " -c:v " + codec) + " -pix_fmt " + format + " " +
           quoted(name));
    media::SourceOptions options{.field_size = {32, 32}, .colour = true};
    const auto frames = read_all(*footage::open_source(name, options));
    ASSERT_EQ(frames.size(), 2u);
    const auto& frame = frames[1];
    const bool is_grey = format == "gray" || format == "gray10le";
    const int tolerance = format == "pal8" ? 14 : 3;
    const double red = 0.114 * 30 + 0.587 * 40 + 0.299 * 200;
    EXPECT_NEAR(frame.grey.at(6, 16), red, tolerance);
    for (const int j : {1, 8, 16, 24, 30}) {
        const double ramp = 255 * (2 * j + 0.5) / 63;
        EXPECT_NEAR(frame.grey.at(26, j), ramp, tolerance) << "row " << j;
        for (const auto channel : frame.colour.at(26, j)) EXPECT_NEAR(channel, ramp, tolerance + 1);
    }
    if (is_grey) return;
    const Bgr colour = frame.colour.at(6, 16);
    EXPECT_NEAR(colour[0], 30, tolerance + 3);
    EXPECT_NEAR(colour[1], 40, tolerance + 3);
    EXPECT_NEAR(colour[2], 200, tolerance + 3);
}

std::string format_of(const testing::TestParamInfo<std::string>& test) {
    return test.param;
}

INSTANTIATE_TEST_SUITE_P(Video, PixelFormats,
                         testing::Values("yuv420p", "yuvj420p", "nv12", "gray", "yuv420p10le", "rgb24", "pal8"),
                         format_of);
INSTANTIATE_TEST_SUITE_P(Nightly, PixelFormats,
                         testing::Values("yuv422p", "yuv444p", "yuv444p16le", "gray10le", "yuva420p", "bgr0", "rgba",
                                         "rgb48be"),
                         format_of);

/// Each pixel the exact mean of the area that it covers.
double area_mean(const Plane<Bgr>& picture, Size to, int i, int j) {
    const double sx = static_cast<double>(picture.width()) / to.width;
    const double sy = static_cast<double>(picture.height()) / to.height;
    double sum = 0;
    double weight = 0;
    for (int y = static_cast<int>(j * sy); y < std::min<double>((j + 1) * sy, picture.height()); ++y) {
        for (int x = static_cast<int>(i * sx); x < std::min<double>((i + 1) * sx, picture.width()); ++x) {
            const double wx = std::min<double>(x + 1, (i + 1) * sx) - std::max<double>(x, i * sx);
            const double wy = std::min<double>(y + 1, (j + 1) * sy) - std::max<double>(y, j * sy);
            sum += wx * wy * picture.at(x, y)[0];
            weight += wx * wy;
        }
    }
    return sum / weight;
}

TEST(Scaler, AveragesAreas) {
    const TempFolder folder;
    generator::Options drawn{.size = {300, 200}, .frames = 2};
    const auto scene = generator::make_shifted_texture(drawn);
    write_scene(scene, folder / "texture.y4m");
    const auto truth = scene.frame(1);
    for (const Size size : {Size{150, 100}, Size{100, 50}, Size{133, 89}, Size{299, 199}, Size{3, 2}, Size{1, 1}}) {
        media::SourceOptions options{.field_size = size};
        const auto frames = read_all(*footage::open_source(folder / "texture.y4m", options));
        ASSERT_EQ(frames.size(), 2u);
        double worst = 0;
        for (int j = 0; j < size.height; ++j) {
            for (int i = 0; i < size.width; ++i) {
                worst = std::max(worst, std::abs(frames[1].grey.at(i, j) - area_mean(truth, size, i, j)));
            }
        }
        // swscale's area filter is as long as the area rounded up to pixels: less exact near the source's own size.
        EXPECT_LE(worst, size.width > 250 ? 12 : 3) << size.width << "x" << size.height;
    }
}

/// Linear between the points (i, j) of a plane, the edges repeated.
double linear_at(const Plane<std::uint8_t>& plane, double x, double y) {
    const auto at = [&](double i, double j) {
        return static_cast<double>(plane.at(static_cast<int>(std::clamp(i, 0.0, plane.width() - 1.0)),
                                            static_cast<int>(std::clamp(j, 0.0, plane.height() - 1.0))));
    };
    const double i = std::floor(x);
    const double j = std::floor(y);
    return std::lerp(std::lerp(at(i, j), at(i + 1, j), x - i), std::lerp(at(i, j + 1), at(i + 1, j + 1), x - i), y - j);
}

// As chroma of 4:2:0 is enlarged to the size of luma.
TEST(Scaler, DoublesLinearly) {
    for (const Size size : {Size{1, 1}, Size{3, 2}, Size{33, 5}, Size{64, 4}, Size{71, 3}}) {
        Plane<std::uint8_t> plane(size);
        std::mt19937 random(5);
        for (std::uint8_t& value : plane.pixels()) value = static_cast<std::uint8_t>(random());
        media::AvFrame image(av_frame_alloc());
        image->width = size.width;
        image->height = size.height;
        image->format = AV_PIX_FMT_GRAY8;
        ASSERT_EQ(av_frame_get_buffer(image.get(), 0), 0);
        for (int j = 0; j < size.height; ++j) {
            std::ranges::copy(plane.row(j), image->data[0] + std::ptrdiff_t{j} * image->linesize[0]);
        }
        const Size doubled{2 * size.width, 2 * size.height};
        const media::Frame twice = media::Scaler(doubled, false)({0, 0, {}, std::move(image)});
        for (int j = 0; j < doubled.height; ++j) {
            for (int i = 0; i < doubled.width; ++i) {
                ASSERT_NEAR(twice.grey.at(i, j), linear_at(plane, i / 2.0 - 0.25, j / 2.0 - 0.25), 0.501)
                    << size.width << "x" << size.height << " at " << i << ", " << j;
            }
        }
    }
}

TEST(Scaler, EnlargesToo) {
    const TempFolder folder;
    write_chart(folder / "chart.y4m", {16, 16});
    media::SourceOptions options{.field_size = {100, 8}, .colour = true};
    const auto frames = read_all(*footage::open_source(folder / "chart.y4m", options));
    EXPECT_EQ(frames[0].grey.size(), (Size{100, 8}));
    EXPECT_NEAR(frames[0].grey.at(10, 4), 87, 3);
}

}  // namespace
}  // namespace vvr
