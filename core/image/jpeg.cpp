#include "core/image/jpeg.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/av_writer.h"
#include "core/base/cv_view.h"
#include "core/base/error.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavutil/error.h>
#include <libavutil/frame.h>
}

namespace vvr::image {

namespace {

// Full chroma: crops of large frames have all of it. The planes are in the order of OpenCV's YCrCb.
constexpr AVPixelFormat pixel_format = AV_PIX_FMT_YUVJ444P;
constexpr std::array planes{0, 2, 1};

constexpr int quantiser = 3;  // 1 to 31; JPEG quality of about 90

void check(int result, const char* what) {
    if (result >= 0) return;
    throw Error(result == AVERROR(ENOMEM) ? ErrorCode::out_of_memory : ErrorCode::io,
                fmt::format("cannot {} a picture in memory: {}; use an FFmpeg that has the codec mjpeg", what,
                            av_error_text(result)));
}

template <class T>
AvPtr<T> owned(T* made, const char* what) {
    check(made == nullptr ? AVERROR(ENOMEM) : 0, what);
    return AvPtr<T>(made);
}

AvPtr<AVCodecContext> make_context(const AVCodec* codec, const char* what) {
    check(codec == nullptr ? AVERROR(ENOSYS) : 0, what);
    AvPtr<AVCodecContext> context = owned(avcodec_alloc_context3(codec), what);
    context->thread_count = 1;
    context->flags |= AV_CODEC_FLAG_BITEXACT;
    context->log_level_offset = 100;  // keep messages off stderr
    return context;
}

cv::Mat view_of(const AVFrame& frame, int plane) {
    return {frame.height, frame.width, CV_8UC1, frame.data[plane], static_cast<std::size_t>(frame.linesize[plane])};
}

AvPtr<AVFrame> to_frame(const Plane<Bgr>& picture) {
    AvPtr<AVFrame> frame = owned(av_frame_alloc(), "compress");
    frame->format = pixel_format;
    frame->color_range = AVCOL_RANGE_JPEG;
    frame->width = picture.width();
    frame->height = picture.height();
    check(av_frame_get_buffer(frame.get(), 0), "compress");
    // The encoder reads beyond the ends of rows, so the padding must be deterministic.
    for (const AVBufferRef* const buffer : frame->buf) {
        if (buffer != nullptr) std::memset(buffer->data, 0, buffer->size);
    }
    cv::Mat converted;
    cv::cvtColor(cv_view(picture), converted, cv::COLOR_BGR2YCrCb);
    for (int channel = 0; channel < 3; ++channel) {
        cv::Mat plane = view_of(*frame, planes[static_cast<std::size_t>(channel)]);
        cv::extractChannel(converted, plane, channel);
    }
    return frame;
}

}  // namespace

std::vector<std::byte> compress(const Plane<Bgr>& picture) {
    const AvPtr<AVCodecContext> context = make_context(avcodec_find_encoder(AV_CODEC_ID_MJPEG), "compress");
    context->width = picture.width();
    context->height = picture.height();
    context->pix_fmt = pixel_format;
    context->color_range = AVCOL_RANGE_JPEG;
    context->time_base = {1, 1};
    context->flags |= AV_CODEC_FLAG_QSCALE;
    context->global_quality = FF_QP2LAMBDA * quantiser;
    check(avcodec_open2(context.get(), nullptr, nullptr), "compress");
    const AvPtr<AVFrame> frame = to_frame(picture);
    frame->quality = context->global_quality;
    const AvPtr<AVPacket> packet = owned(av_packet_alloc(), "compress");
    check(avcodec_send_frame(context.get(), frame.get()), "compress");
    check(avcodec_receive_packet(context.get(), packet.get()), "compress");
    const auto bytes = std::as_bytes(std::span(packet->data, static_cast<std::size_t>(packet->size)));
    return {bytes.begin(), bytes.end()};
}

Plane<Bgr> decompress(std::span<const std::byte> jpeg) {
    const AvPtr<AVCodecContext> context = make_context(avcodec_find_decoder(AV_CODEC_ID_MJPEG), "decompress");
    check(avcodec_open2(context.get(), nullptr, nullptr), "decompress");
    const AvPtr<AVPacket> packet = owned(av_packet_alloc(), "decompress");
    check(av_new_packet(packet.get(), static_cast<int>(jpeg.size())), "decompress");
    std::memcpy(packet->data, jpeg.data(), jpeg.size());
    const AvPtr<AVFrame> frame = owned(av_frame_alloc(), "decompress");
    check(avcodec_send_packet(context.get(), packet.get()), "decompress");
    check(avcodec_receive_frame(context.get(), frame.get()), "decompress");
    check(frame->format == pixel_format ? 0 : AVERROR_INVALIDDATA, "decompress");
    cv::Mat converted(frame->height, frame->width, CV_8UC3);
    for (int channel = 0; channel < 3; ++channel) {
        cv::insertChannel(view_of(*frame, planes[static_cast<std::size_t>(channel)]), converted, channel);
    }
    Plane<Bgr> picture = Plane<Bgr>::for_overwrite({frame->width, frame->height});
    cv::Mat out = cv_view(picture);
    cv::cvtColor(converted, out, cv::COLOR_YCrCb2BGR);
    return picture;
}

}  // namespace vvr::image
