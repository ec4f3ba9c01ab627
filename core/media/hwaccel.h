#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/setting.h"
#include "core/media/av.h"

extern "C" {
#include <libavutil/hwcontext.h>
}

namespace vvr::media {

/// What decodes a video: the processor, or a kind of hardware that libav can use.
struct HwaccelRow {
    std::string_view name;
    AVHWDeviceType device;  ///< AV_HWDEVICE_TYPE_NONE = the processor
    std::string_view help;
    std::string_view needs{};  ///< what a machine must have to open the device
};

/// "none", "vaapi", "cuda".
std::span<const HwaccelRow> hwaccels();

const HwaccelRow& row_of(Name<HwaccelRow> name);

/// Opens the hardware. libav chooses the device if there are several.
/// \throws Error hwaccel_unavailable if it can't be opened
av::Ptr<AVBufferRef> open_device(const HwaccelRow& hwaccel);

/// The pixel format of frames that the codec decodes with such a device; AV_PIX_FMT_NONE if it can't use one.
AVPixelFormat hardware_format(const AVCodec& codec, AVHWDeviceType device);

/// The pixel format in which a decoder is to give its frames: `hardware` if that is offered, else the first format in
/// the processor's memory; AV_PIX_FMT_NONE if neither is offered.
/// \param offered ends with AV_PIX_FMT_NONE
AVPixelFormat choose_format(const AVPixelFormat* offered, AVPixelFormat hardware);

/// Makes a decoder use the device. If the device refuses a video, the decoder goes on in software, and the errors that
/// libav has logged by then do not count as damage (`av::Log::excused`).
/// \pre the codec has a `hardware_format`, a log is attached, and the decoder is not yet open
void use_device(AVCodecContext& decoder, av::Ptr<AVBufferRef> device);

/// The frame in the processor's memory, with all its properties. Frames that are there already stay as they are.
/// \throws Error hwaccel_unavailable if the hardware does not give its frame, out_of_memory
AvFrame downloaded(AvFrame frame);

/// The warning that a video was decoded on the processor instead.
std::string text_of_fallback(const HwaccelRow& asked, std::string_view codec);

}  // namespace vvr::media
