#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include "core/base/cv_view.h"
#include "core/media/scaler.h"
#include "tests/support/planes.h"

namespace vvr {
namespace {

using media::DecodedFrame;
using media::Frame;
using media::Orientation;

/// Waves of several lengths and colours, so that every place looks different.
Plane<Bgr> chart(Size size) {
    const auto wave = [](double x) { return static_cast<std::uint8_t>(std::lround(128 + 90 * std::sin(x))); };
    return test::plane_of<Bgr>(size, [&](int i, int j) {
        return Bgr{wave(0.07 * i + 0.02 * j), wave(0.4 * i - 0.3 * j), wave(0.05 * j + 0.0004 * i * j)};
    });
}

std::shared_ptr<const DecodedFrame> decoded(Size size, AVPixelFormat format, Orientation orientation) {
    const Plane<Bgr> picture = chart(size);
    media::AvFrame image(av_frame_alloc());
    image->width = size.width;
    image->height = size.height;
    image->format = format;
    if (av_frame_get_buffer(image.get(), 0) != 0) throw std::bad_alloc();
    SwsContext* const context = sws_getContext(size.width, size.height, AV_PIX_FMT_BGR24, size.width, size.height,
                                               format, SWS_BILINEAR | SWS_ACCURATE_RND, nullptr, nullptr, nullptr);
    const std::uint8_t* const rows[] = {picture.pixels().front().data()};
    const int strides[] = {3 * size.width};
    sws_scale(context, rows, strides, 0, size.height, image->data, image->linesize);
    sws_freeContext(context);
    return std::make_shared<const DecodedFrame>(DecodedFrame{3, 0.5, orientation, std::move(image)});
}

/// The frame at the field size, as the pipeline makes it.
Frame frame_of(const std::shared_ptr<const DecodedFrame>& from, Size field) {
    Frame frame = media::Scaler(field, true)(*from);
    frame.full_size.picture = from;
    return frame;
}

Plane<Bgr> part_of(const Plane<Bgr>& picture, const PixelBox& box) {
    Plane<Bgr> part(box.size());
    cv_view(picture)(cv::Rect(box.left, box.top, box.width(), box.height())).copyTo(cv_view(part));
    return part;
}

struct Difference {
    double worst = 0;
    double mean = 0;
};

Difference difference(const Plane<Bgr>& a, const Plane<Bgr>& b) {
    const cv::Mat one = cv_view(a);
    const cv::Mat other = cv_view(b);
    return {cv::norm(one, other, cv::NORM_INF),
            cv::norm(one, other, cv::NORM_L1) / static_cast<double>(3 * a.pixels().size())};
}

class CropFormats : public testing::TestWithParam<AVPixelFormat> {};

TEST_P(CropFormats, GiveTheSamePartAsTheWholePicture) {
    const auto full = decoded({320, 240}, GetParam(), {});
    const Plane<Bgr> whole = media::Scaler({320, 240}, true)(*full).colour;
    const Frame frame = frame_of(full, {80, 60});
    for (const PixelBox box : {PixelBox{11, 7, 38, 34}, PixelBox{0, 0, 20, 20}, PixelBox{61, 45, 80, 60},
                               PixelBox{0, 0, 80, 60}, PixelBox{40, 30, 41, 31}}) {
        const Plane<Bgr> crop = media::crop_of(frame, box, 1000);
        ASSERT_EQ(crop.size(), (Size{4 * box.width(), 4 * box.height()}));
        const PixelBox shown{4 * box.left, 4 * box.top, 4 * box.right, 4 * box.bottom};
        EXPECT_LE(difference(crop, part_of(whole, shown)).worst, 1) << box.left << ", " << box.top;
    }
}

INSTANTIATE_TEST_SUITE_P(Video, CropFormats,
                         testing::Values(AV_PIX_FMT_YUV420P, AV_PIX_FMT_YUVJ420P, AV_PIX_FMT_YUV410P, AV_PIX_FMT_NV12,
                                         AV_PIX_FMT_GRAY8, AV_PIX_FMT_YUV420P10LE, AV_PIX_FMT_YUYV422,
                                         AV_PIX_FMT_UYVY422, AV_PIX_FMT_RGB24, AV_PIX_FMT_GBRP, AV_PIX_FMT_MONOBLACK),
                         [](const auto& test) { return std::string(av_get_pix_fmt_name(test.param)); });

class CropOrientations : public testing::TestWithParam<int> {};

TEST_P(CropOrientations, AreUpright) {
    const int bits = GetParam();
    const Orientation orientation{(bits & 4) != 0, (bits & 2) != 0, (bits & 1) != 0};
    const auto full = decoded({320, 200}, AV_PIX_FMT_YUV420P, orientation);
    const Size upright = orientation.transpose ? Size{200, 320} : Size{320, 200};
    const Plane<Bgr> whole = media::Scaler(upright, true)(*full).colour;
    const Frame frame = frame_of(full, {upright.width / 4, upright.height / 4});
    const Plane<Bgr> crop = media::crop_of(frame, {5, 9, 35, 39}, 1000);
    ASSERT_EQ(crop.size(), (Size{120, 120}));
    EXPECT_LE(difference(crop, part_of(whole, {20, 36, 140, 156})).worst, 1);
}

INSTANTIATE_TEST_SUITE_P(Video, CropOrientations, testing::Range(0, 8));

TEST(Crop, HasSquarePixels) {
    const auto full = decoded({160, 240}, AV_PIX_FMT_YUV420P, {});
    const Plane<Bgr> shown = media::Scaler({320, 240}, true)(*full).colour;
    const Frame frame = frame_of(full, {80, 60});
    const Plane<Bgr> crop = media::crop_of(frame, {10, 10, 30, 30}, 1000);
    ASSERT_EQ(crop.size(), (Size{80, 80}));
    EXPECT_LE(difference(crop, part_of(shown, {40, 40, 120, 120})).mean, 1);
}

TEST(Crop, IsShrunkByAreas) {
    const auto full = decoded({640, 480}, AV_PIX_FMT_YUV420P, {});
    const Plane<Bgr> whole = media::Scaler({640, 480}, true)(*full).colour;
    const Frame frame = frame_of(full, {160, 120});
    // A box for which no edge has to be rounded.
    const Plane<Bgr> crop = media::crop_of(frame, {20, 12, 120, 112}, 150);
    ASSERT_EQ(crop.size(), (Size{150, 150}));
    Plane<Bgr> expected({150, 150});
    cv::Mat out = cv_view(expected);
    cv::resize(cv_view(part_of(whole, {80, 48, 480, 448})), out, out.size(), 0, 0, cv::INTER_AREA);
    EXPECT_LE(difference(crop, expected).mean, 3);
}

TEST(Crop, FollowsAnAlignedFrame) {
    const auto full = decoded({320, 240}, AV_PIX_FMT_YUV420P, {});
    const Plane<Bgr> whole = media::Scaler({320, 240}, true)(*full).colour;
    Frame frame = frame_of(full, {80, 60});
    frame.full_size.left = 1.5;
    frame.full_size.top = -2;
    const Plane<Bgr> crop = media::crop_of(frame, {10, 10, 30, 30}, 1000);
    EXPECT_LE(difference(crop, part_of(whole, {46, 32, 126, 112})).worst, 1);
    const Plane<Bgr> edge = media::crop_of(frame, {0, 0, 20, 20}, 1000);
    EXPECT_LE(difference(part_of(edge, {0, 8, 80, 80}), part_of(whole, {6, 0, 86, 72})).worst, 1);
    EXPECT_EQ(edge.at(5, 0), edge.at(5, 8)) << "beyond the picture, its edge is repeated";
    frame.full_size.left = 1000;
    EXPECT_EQ(media::crop_of(frame, {0, 0, 20, 20}, 1000).size(), (Size{20, 20})) << "nothing of the picture";
}

TEST(Crop, IsOfTheFrameItselfWithoutAPicture) {
    auto full = decoded({320, 240}, AV_PIX_FMT_YUV420P, {});
    Frame frame = frame_of(full, {80, 60});
    full.reset();
    const PixelBox box{5, 6, 25, 26};
    EXPECT_EQ(difference(media::crop_of(frame, box, 1000), part_of(frame.colour, box)).worst, 0);
    EXPECT_EQ(media::crop_of(frame, box, 10).size(), (Size{10, 10}));
    frame.colour = {};
    const std::uint8_t grey = frame.grey.at(5, 6);
    EXPECT_EQ(media::crop_of(frame, box, 1000).at(0, 0), (Bgr{grey, grey, grey}));
}

TEST(Crop, IsOfTheFrameItselfIfThatIsAsLarge) {
    const auto full = decoded({80, 60}, AV_PIX_FMT_YUV420P, {});
    const Frame frame = frame_of(full, {80, 60});
    const PixelBox box{5, 6, 25, 26};
    EXPECT_EQ(difference(media::crop_of(frame, box, 1000), part_of(frame.colour, box)).worst, 0);
}

// As libav's decoders may return pictures whose format changes, or is not for pictures in memory.
TEST(Crop, IsOfTheFrameItselfIfThePictureCannotBeConverted) {
    auto full = decoded({320, 240}, AV_PIX_FMT_YUV420P, {});
    const Frame frame = frame_of(full, {80, 60});
    full->image->format = AV_PIX_FMT_VAAPI;
    EXPECT_EQ(media::crop_of(frame, {5, 6, 25, 26}, 1000).size(), (Size{20, 20}));
}

}  // namespace
}  // namespace vvr
