#include "core/media/av.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <string_view>

#include "core/base/error.h"

extern "C" {
#include <libavutil/error.h>
#include <libavutil/frame.h>
#include <libavutil/log.h>
#include <libavutil/mem.h>
}

namespace vvr::media {

namespace av {
namespace {

// libav calls the log callback for every context of the process. The address of this function, like that of
// Log::interrupted, marks our contexts, so that the callback never casts another library's opaque pointer to a Log.
// Decoders don't use this encoder callback.
int never_encode(AVCodecContext*, AVPacket*, int) {
    return AVERROR(ENOSYS);
}

Error out_of_memory() {
    return {ErrorCode::out_of_memory, "out of memory for a video frame; use fewer threads", {"threads"}};
}

}  // namespace

Ptr<AVPacket> make_packet() {
    Ptr<AVPacket> packet(av_packet_alloc());
    if (!packet) throw out_of_memory();
    return packet;
}

void throw_out_of_memory() {
    throw Error(ErrorCode::out_of_memory, "out of memory while reading the video; give vvr more memory");
}

Ptr<AVPacket> copy_of(const AVPacket& packet) {
    Ptr<AVPacket> copy(av_packet_clone(&packet));
    if (!copy) throw_out_of_memory();
    return copy;
}

AvFrame make_frame() {
    AvFrame frame(av_frame_alloc());
    if (!frame) throw out_of_memory();
    return frame;
}

AVColorSpace colour_space_of(const AVFrame& frame) {
    if (frame.colorspace != AVCOL_SPC_UNSPECIFIED && frame.colorspace != AVCOL_SPC_RGB) return frame.colorspace;
    return frame.height > 576 ? AVCOL_SPC_BT709 : AVCOL_SPC_SMPTE170M;
}

Ptr<AVIOContext> make_reader(void* self, int (*read)(void*, std::uint8_t*, int),
                             std::int64_t (*seek)(void*, std::int64_t, int)) {
    constexpr int buffer_size = 1 << 16;
    Ptr<AVIOContext> context;
    auto* buffer = static_cast<unsigned char*>(av_malloc(buffer_size));
    if (buffer) context.reset(avio_alloc_context(buffer, buffer_size, 0, self, read, nullptr, seek));
    if (!context) {
        av_free(buffer);
        throw Error(ErrorCode::out_of_memory, "out of memory for opening a video; give vvr more memory");
    }
    return context;
}

void Log::attach(AVFormatContext& context, const Watchdog* watchdog) {
    av_log_set_callback(&Log::receive);
    watchdog_ = watchdog;
    context.interrupt_callback = {&Log::interrupted, this};
}

int Log::interrupted(void* self) {
    const Watchdog* const watchdog = static_cast<const Log*>(self)->watchdog_;
    return watchdog != nullptr && watchdog->expired() ? 1 : 0;
}

void Log::attach(AVCodecContext& context) {
    av_log_set_callback(&Log::receive);
    context.get_encode_buffer = &never_encode;
    context.opaque = this;
}

int Log::get_buffer(AVCodecContext* context, AVFrame* frame, int flags) {
    const int code = avcodec_default_get_buffer2(context, frame, flags);
    if (code == AVERROR(ENOMEM)) static_cast<Log*>(context->opaque)->out_of_memory_ = true;
    return code;
}

void Log::excuse(AVCodecContext& context) {
    Log& log = *static_cast<Log*>(context.opaque);
    log.excused_ = log.errors();
}

void Log::receive(void* context, int level, const char* format, va_list arguments) {
    // libav logs error concealment below the error level, and with threads loses the frame's own error flag.
    const bool is_concealment = std::string_view(format).starts_with("concealing");
    if (!context || (level > AV_LOG_ERROR && !is_concealment)) return;
    const AVClass* kind = *static_cast<const AVClass**>(context);
    if (!kind || !kind->class_name) return;

    Log* log = nullptr;
    if (kind == avformat_get_class()) {
        const auto* owner = static_cast<const AVFormatContext*>(context);
        if (owner->interrupt_callback.callback == &Log::interrupted) {
            log = static_cast<Log*>(owner->interrupt_callback.opaque);
        }
    } else if (kind == avcodec_get_class()) {
        const auto* owner = static_cast<const AVCodecContext*>(context);
        if (owner->get_encode_buffer == &never_encode) log = static_cast<Log*>(owner->opaque);
    }
    if (!log) return;

    std::array<char, 256> line{};
    std::vsnprintf(line.data(), line.size(), format, arguments);
    log->keep(line.data());
}

void Log::keep(const std::string& line) {
    std::string clean;
    for (const char c : line) clean += (c >= ' ' && c <= '~') ? c : ' ';
    const auto last = clean.find_last_not_of(" .");
    const auto first = clean.find_first_not_of(' ');
    if (last == std::string::npos) return;
    const std::lock_guard lock(mutex_);
    last_ = clean.substr(first, last - first + 1);
    ++errors_;
}

std::int64_t Log::errors() const {
    const std::lock_guard lock(mutex_);
    return errors_;
}

bool Log::has_text() const {
    const std::lock_guard lock(mutex_);
    return !last_.empty();
}

std::string Log::text(int code) const {
    {
        const std::lock_guard lock(mutex_);
        if (!last_.empty()) return last_;
    }
    return av_error_text(code);
}

}  // namespace av
}  // namespace vvr::media
