#include "core/base/av_writer.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <new>
#include <utility>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avio.h>
#include <libavutil/error.h>
#include <libavutil/mem.h>
#include <libswscale/swscale.h>
}

namespace vvr {

void AvFree::operator()(AVCodecContext* context) const {
    avcodec_free_context(&context);
}

void AvFree::operator()(AVFrame* frame) const {
    av_frame_free(&frame);
}

void AvFree::operator()(AVIOContext* context) const {
    if (context != nullptr) av_freep(&context->buffer);
    avio_context_free(&context);
}

void AvFree::operator()(AVPacket* packet) const {
    av_packet_free(&packet);
}

void AvFree::operator()(SwsContext* context) const {
    sws_freeContext(context);
}

std::string av_error_text(int error) {
    std::array<char, AV_ERROR_MAX_STRING_SIZE> words{};
    av_strerror(error, words.data(), words.size());
    return words.data();
}

AvWriter::AvWriter(WriteAt write_at) : write_at_(std::move(write_at)) {
    constexpr int buffer_size = 1 << 16;
    auto* const buffer = static_cast<unsigned char*>(av_malloc(buffer_size));
    if (buffer == nullptr) throw std::bad_alloc();
    context_.reset(avio_alloc_context(buffer, buffer_size, 1, this, nullptr, &AvWriter::write, &AvWriter::seek));
    if (context_) return;
    av_free(buffer);
    throw std::bad_alloc();
}

AvWriter::~AvWriter() = default;

void AvWriter::flush() {
    avio_flush(context_.get());
    check();
}

void AvWriter::check() const {
    if (failed_) std::rethrow_exception(failed_);
}

template <class Byte>
int AvWriter::write(void* self, Byte* bytes, int size) {
    auto& writer = *static_cast<AvWriter*>(self);
    if (writer.failed_) return AVERROR(EIO);
    try {
        writer.write_at_(writer.at_, std::as_bytes(std::span(bytes, static_cast<std::size_t>(size))));
    } catch (...) {
        writer.failed_ = std::current_exception();
        return AVERROR(EIO);
    }
    writer.at_ += size;
    writer.size_ = std::max(writer.size_, writer.at_);
    return size;
}

std::int64_t AvWriter::seek(void* self, std::int64_t offset, int whence) {
    auto& writer = *static_cast<AvWriter*>(self);
    if (whence == AVSEEK_SIZE) return writer.size_;
    const std::int64_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? writer.at_ : writer.size_;
    if (base + offset < 0 || base + offset > writer.size_) return AVERROR(EINVAL);
    return writer.at_ = base + offset;
}

}  // namespace vvr
