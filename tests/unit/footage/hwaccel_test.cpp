#include "core/media/hwaccel.h"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/footage/open_source.h"
#include "core/footage/recorder_names.h"
#include "core/media/demuxer.h"
#include "tests/support/errors.h"
#include "tests/unit/media/clips.h"

namespace vvr {
namespace {

using namespace test;

constexpr auto vaapi = AV_HWDEVICE_TYPE_VAAPI;

const AVCodec& codec_of(AVCodecID id) {
    return *avcodec_find_decoder(id);
}

TEST(Hwaccel, HardwareIsChosenWhereverTheDecoderOffersIt) {
    const std::array first{AV_PIX_FMT_VAAPI, AV_PIX_FMT_YUV420P, AV_PIX_FMT_NONE};
    const std::array later{AV_PIX_FMT_CUDA, AV_PIX_FMT_YUV420P, AV_PIX_FMT_VAAPI, AV_PIX_FMT_NONE};
    EXPECT_EQ(media::choose_format(first.data(), AV_PIX_FMT_VAAPI), AV_PIX_FMT_VAAPI);
    EXPECT_EQ(media::choose_format(later.data(), AV_PIX_FMT_VAAPI), AV_PIX_FMT_VAAPI);
}

TEST(Hwaccel, WithoutItTheFirstFormatInMemoryIsChosen) {
    const std::array offered{AV_PIX_FMT_CUDA, AV_PIX_FMT_VDPAU, AV_PIX_FMT_YUV420P, AV_PIX_FMT_NV12, AV_PIX_FMT_NONE};
    EXPECT_EQ(media::choose_format(offered.data(), AV_PIX_FMT_VAAPI), AV_PIX_FMT_YUV420P);
    EXPECT_EQ(media::choose_format(offered.data(), AV_PIX_FMT_NONE), AV_PIX_FMT_YUV420P);
    const std::array other_hardware{AV_PIX_FMT_CUDA, AV_PIX_FMT_VDPAU, AV_PIX_FMT_NONE};
    EXPECT_EQ(media::choose_format(other_hardware.data(), AV_PIX_FMT_VAAPI), AV_PIX_FMT_NONE);
    const std::array nothing{AV_PIX_FMT_NONE};
    EXPECT_EQ(media::choose_format(nothing.data(), AV_PIX_FMT_VAAPI), AV_PIX_FMT_NONE);
}

TEST(Hwaccel, EachCodecTellsItsFormat) {
    EXPECT_EQ(media::hardware_format(codec_of(AV_CODEC_ID_H264), vaapi), AV_PIX_FMT_VAAPI);
    EXPECT_EQ(media::hardware_format(codec_of(AV_CODEC_ID_HEVC), AV_HWDEVICE_TYPE_CUDA), AV_PIX_FMT_CUDA);
    EXPECT_EQ(media::hardware_format(codec_of(AV_CODEC_ID_FFV1), vaapi), AV_PIX_FMT_NONE);
    EXPECT_EQ(media::hardware_format(codec_of(AV_CODEC_ID_H264), AV_HWDEVICE_TYPE_NONE), AV_PIX_FMT_NONE);
}

TEST(Hwaccel, OtherNamesAreRefused) {
    expect_error(ErrorCode::choice_unknown, [] { media::row_of(Name<media::HwaccelRow>{"vappi"}); },
                 {"hwaccel", "vappi", "vaapi", "cuda"});
    EXPECT_EQ(media::hwaccels().front().device, AV_HWDEVICE_TYPE_NONE);
}

/// A device that is not set up, so it refuses every video.
media::av::Ptr<AVBufferRef> refusing_device() {
    return media::av::Ptr<AVBufferRef>(av_hwdevice_ctx_alloc(vaapi));
}

TEST(Hwaccel, AVideoThatTheDeviceRefusesIsDecodedInSoftwareWithoutDamage) {
    const TempFolder folder;
    const std::string clip = walkers_clip(folder, "clip.mp4", "-c:v libx264");
    media::Demuxer demuxer(media::open_file(clip), media::Demuxer::Kind::video, 0);
    const AVCodec& codec = codec_of(AV_CODEC_ID_H264);
    const media::av::Ptr<AVCodecContext> decoder(avcodec_alloc_context3(&codec));
    demuxer.log().attach(*decoder);
    ASSERT_GE(avcodec_parameters_to_context(decoder.get(), demuxer.stream().codecpar), 0);
    media::use_device(*decoder, refusing_device());
    ASSERT_EQ(avcodec_open2(decoder.get(), &codec, nullptr), 0);

    const auto packet = media::av::make_packet();
    int frames = 0;
    for (bool more = true; more;) {
        more = demuxer.read(*packet);
        ASSERT_EQ(avcodec_send_packet(decoder.get(), more ? packet.get() : nullptr), 0);
        for (auto frame = media::av::make_frame(); avcodec_receive_frame(decoder.get(), frame.get()) == 0; ++frames) {
            EXPECT_EQ(frame->format, AV_PIX_FMT_YUV420P);
            const AVFrame* const same = frame.get();
            frame = media::downloaded(std::move(frame));
            EXPECT_EQ(frame.get(), same);
        }
    }
    EXPECT_EQ(frames, 75);
    EXPECT_GT(demuxer.log().errors(), 0);
    EXPECT_EQ(demuxer.log().excused(), demuxer.log().errors());
}

TEST(Hwaccel, ADeviceThatIsNotThereIsAnError) {
    const TempFolder folder;
    const std::string clip = walkers_clip(folder, "clip.mp4", "-c:v libx264");
    int missing = 0;
    for (const media::HwaccelRow& row : media::hwaccels()) {
        if (row.device == AV_HWDEVICE_TYPE_NONE) continue;
        try {
            media::open_device(row);
        } catch (const Error&) {
            ++missing;
            expect_error(ErrorCode::hwaccel_unavailable, [&] { footage::open_source(clip, {.hwaccel = row}); },
                         {"hwaccel", std::string(row.name), std::string(row.needs)});
        }
    }
    if (missing == 0) GTEST_SKIP() << "this machine has all kinds of hardware";
}

TEST(Hwaccel, ACodecWithoutHardwareIsDecodedAsWithoutTheSettingAndToldOnce) {
    const TempFolder folder;
    const std::string clip = walkers_clip(folder, "cam_20260101_100000.mkv", "-c:v ffv1");
    const auto plain = footage::open_source(clip);
    const auto asked = footage::open_source(clip, {.hwaccel = "vaapi"});
    EXPECT_EQ(fingerprint(read_all(*asked)), fingerprint(read_all(*plain)));
    EXPECT_EQ(asked->info().hwaccel->name, "none");
    EXPECT_EQ(plain->problems().size(), 0U);
    ASSERT_EQ(asked->problems().size(), 1U);
    for (const char* const fact : {"vaapi", "ffv1"}) EXPECT_NE(asked->problems().front().find(fact), std::string::npos);

    const std::string second = folder / "cam_20260101_100003.mkv";
    std::filesystem::copy_file(clip, second);
    std::vector<std::string> warnings;
    const auto recording =
        footage::open_sources({clip, second}, {.hwaccel = "vaapi"}, footage::RecorderNames(), warnings);
    EXPECT_EQ(read_all(*recording).size(), 150U);
    EXPECT_EQ(recording->problems(), asked->problems());
}

}  // namespace
}  // namespace vvr
