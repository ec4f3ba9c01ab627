#include "core/media/hwaccel.h"

#include <array>
#include <cerrno>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"

extern "C" {
#include <libavutil/pixdesc.h>
}

namespace vvr::media {
namespace {

constexpr std::array hwaccel_rows{
    HwaccelRow{"none", AV_HWDEVICE_TYPE_NONE, "the processor decodes"},
    HwaccelRow{"vaapi", AV_HWDEVICE_TYPE_VAAPI, "VA-API, for Intel and AMD",
               "a graphics card, its VA-API driver, and access to /dev/dri"},
    HwaccelRow{"cuda", AV_HWDEVICE_TYPE_CUDA, "NVDEC, for NVIDIA", "an NVIDIA card and NVIDIA's driver"},
};

AVPixelFormat get_format(AVCodecContext* decoder, const AVPixelFormat* offered) {
    const auto* const device = reinterpret_cast<const AVHWDeviceContext*>(decoder->hw_device_ctx->data);
    const AVPixelFormat hardware = hardware_format(*decoder->codec, device->type);
    const AVPixelFormat chosen = choose_format(offered, hardware);
    if (chosen != hardware) av::Log::excuse(*decoder);
    return chosen;
}

}  // namespace

std::span<const HwaccelRow> hwaccels() {
    return hwaccel_rows;
}

const HwaccelRow& row_of(Name<HwaccelRow> name) {
    return choose("hwaccel", name.text, hwaccels());
}

av::Ptr<AVBufferRef> open_device(const HwaccelRow& hwaccel) {
    av::Log::keep_off_stderr();
    AVBufferRef* device = nullptr;
    const int code = av_hwdevice_ctx_create(&device, hwaccel.device, nullptr, nullptr, 0);
    if (code >= 0) return av::Ptr<AVBufferRef>(device);
    throw Error(
        ErrorCode::hwaccel_unavailable,
        fmt::format("hwaccel {}: no such device can be opened here (FFmpeg: {}); it needs {}; leave the setting "
                    "out to decode on the processor",
                    hwaccel.name, av_error_text(code), hwaccel.needs),
        {"hwaccel"});
}

AVPixelFormat hardware_format(const AVCodec& codec, AVHWDeviceType device) {
    for (int i = 0;; ++i) {
        const AVCodecHWConfig* const config = avcodec_get_hw_config(&codec, i);
        if (config == nullptr) return AV_PIX_FMT_NONE;
        const bool takes_device = (config->methods & AV_CODEC_HW_CONFIG_METHOD_HW_DEVICE_CTX) != 0;
        if (takes_device && config->device_type == device) return config->pix_fmt;
    }
}

AVPixelFormat choose_format(const AVPixelFormat* offered, AVPixelFormat hardware) {
    AVPixelFormat software = AV_PIX_FMT_NONE;
    for (; *offered != AV_PIX_FMT_NONE; ++offered) {
        if (*offered == hardware) return hardware;
        const AVPixFmtDescriptor* const format = av_pix_fmt_desc_get(*offered);
        const bool in_memory = format != nullptr && (format->flags & AV_PIX_FMT_FLAG_HWACCEL) == 0;
        if (in_memory && software == AV_PIX_FMT_NONE) software = *offered;
    }
    return software;
}

void use_device(AVCodecContext& decoder, av::Ptr<AVBufferRef> device) {
    decoder.hw_device_ctx = device.release();
    decoder.get_format = &get_format;
    // Hardware gains nothing from threads, and each would hold more of its few frames.
    decoder.thread_count = 1;
}

AvFrame downloaded(AvFrame frame) {
    if (frame->hw_frames_ctx == nullptr) return frame;
    AvFrame copy = av::make_frame();
    int code = av_hwframe_transfer_data(copy.get(), frame.get(), 0);
    if (code >= 0) code = av_frame_copy_props(copy.get(), frame.get());
    if (code >= 0) return copy;
    if (code == AVERROR(ENOMEM))
        throw Error(ErrorCode::out_of_memory, "out of memory for a decoded frame; give vvr more memory");
    throw Error(ErrorCode::hwaccel_unavailable,
                fmt::format("hwaccel: cannot copy the decoded frame from the device (FFmpeg: {}); leave the "
                            "setting out to decode on the processor",
                            av_error_text(code)),
                {"hwaccel"});
}

std::string text_of_fallback(const HwaccelRow& asked, std::string_view codec) {
    return fmt::format("hwaccel {}: this FFmpeg or the device can't decode such {} video; the processor decodes it",
                       asked.name, codec);
}

}  // namespace vvr::media
