#include "core/video/frame_store.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/imgutils.h>
}

#include "core/plane.h"
#include "core/video/av.h"

namespace vvr {
namespace {

AvFrame blank(Size size, AVPixelFormat format) {
    AvFrame picture = av::make_frame();
    picture->width = size.width;
    picture->height = size.height;
    picture->format = format;
    picture->color_range = AVCOL_RANGE_MPEG;
    picture->colorspace = AVCOL_SPC_BT709;
    if (av_frame_get_buffer(picture.get(), 0) < 0) throw std::bad_alloc();
    return picture;
}

std::vector<std::uint8_t> bytes_of(const AVFrame& picture) {
    const auto format = static_cast<AVPixelFormat>(picture.format);
    std::vector<std::uint8_t> bytes(
        static_cast<std::size_t>(av_image_get_buffer_size(format, picture.width, picture.height, 1)));
    av_image_copy_to_buffer(bytes.data(), static_cast<int>(bytes.size()), picture.data, picture.linesize, format,
                            picture.width, picture.height, 1);
    return bytes;
}

void fill(const AVFrame& picture, std::vector<std::uint8_t>& bytes) {
    std::uint8_t* planes[4];
    int strides[4];
    const auto format = static_cast<AVPixelFormat>(picture.format);
    av_image_fill_arrays(planes, strides, bytes.data(), format, picture.width, picture.height, 1);
    av_image_copy(const_cast<std::uint8_t**>(picture.data), const_cast<int*>(picture.linesize),
                  const_cast<const std::uint8_t**>(planes), strides, format, picture.width, picture.height);
}

struct Kind {
    Size size;
    AVPixelFormat format;
};

TEST(FrameStore, GivesBackWhatItTookByteForByte) {
    for (const Kind& kind :
         {Kind{{384, 288}, AV_PIX_FMT_YUV444P}, Kind{{65, 17}, AV_PIX_FMT_YUV444P}, Kind{{33, 9}, AV_PIX_FMT_YUV420P},
          Kind{{1, 1}, AV_PIX_FMT_GRAY8}, Kind{{40, 1}, AV_PIX_FMT_GRAY8}, Kind{{7, 200}, AV_PIX_FMT_NV12}}) {
        std::mt19937 random(11);
        FrameStore store;
        AvFrame picture = blank(kind.size, kind.format);
        std::vector<std::uint8_t> bytes = bytes_of(*picture);
        std::vector<std::vector<std::uint8_t>> wanted;
        // Nothing, then differences at the edges of each width, and of all sizes, wrapping around at 0 and 255.
        for (const int most : {0, 1, 2, 3, 7, 8, 9, 127, 128, 255, 0, 2}) {
            std::uniform_int_distribution<int> change(-most, most);
            for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(byte + change(random));
            fill(*picture, bytes);
            ASSERT_TRUE(store.push(*picture));
            wanted.push_back(bytes);
        }
        ASSERT_EQ(store.size(), wanted.size());
        for (const auto& expected : wanted) {
            const AvFrame got = store.pop();
            ASSERT_TRUE(got);
            EXPECT_EQ(got->color_range, AVCOL_RANGE_MPEG);
            EXPECT_EQ(got->colorspace, AVCOL_SPC_BT709);
            EXPECT_EQ(bytes_of(*got), expected) << kind.size.width << "x" << kind.size.height;
        }
        EXPECT_FALSE(store.pop());
        EXPECT_EQ(store.bytes(), 0u);
    }
}

TEST(FrameStore, OneSideFillsWhileTheOtherEmpties) {
    FrameStore store;
    AvFrame picture = blank({640, 480}, AV_PIX_FMT_YUV444P);
    std::vector<std::uint8_t> bytes = bytes_of(*picture);
    std::mt19937 random(3);
    for (int i = 0; i < 20; ++i) {
        for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
        fill(*picture, bytes);
        ASSERT_TRUE(store.push(*picture));
        EXPECT_EQ(bytes_of(*store.pop()), bytes) << i;
        EXPECT_LT(store.bytes(), 8u << 20U);
    }
}

TEST(FrameStore, TakesLittleForWhatStandsStill) {
    const AvFrame picture = blank({384, 288}, AV_PIX_FMT_YUV444P);
    std::vector<std::uint8_t> bytes = bytes_of(*picture);
    std::mt19937 random(5);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    fill(*picture, bytes);
    FrameStore store;
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(store.push(*picture));
    EXPECT_GT(store.bytes(), bytes.size());
    EXPECT_LT(store.bytes(), 3 * bytes.size() / 2);
}

TEST(FrameStore, LeavesOutWhatIsNotLikeTheFirst) {
    FrameStore store;
    ASSERT_TRUE(store.push(*blank({32, 32}, AV_PIX_FMT_GRAY8)));
    EXPECT_FALSE(store.push(*blank({32, 40}, AV_PIX_FMT_GRAY8)));
    EXPECT_FALSE(store.push(*blank({32, 32}, AV_PIX_FMT_YUV444P)));
    const AvFrame other = blank({32, 32}, AV_PIX_FMT_GRAY8);
    other->color_range = AVCOL_RANGE_JPEG;
    EXPECT_FALSE(store.push(*other));
    EXPECT_EQ(store.size(), 1u);
}

}  // namespace
}  // namespace vvr
