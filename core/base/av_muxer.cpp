#include "core/base/av_muxer.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <new>
#include <utility>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
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

void AvMuxer::Free::operator()(AVFormatContext* context) const {
    avformat_free_context(context);
}

AvMuxer::AvMuxer(const char* muxer, WriteAt write_at, Fail fail)
    : write_at_(std::move(write_at)), fail_(std::move(fail)) {
    constexpr int buffer_size = 1 << 16;
    auto* const buffer = static_cast<unsigned char*>(av_malloc(buffer_size));
    if (buffer == nullptr) throw std::bad_alloc();
    io_.reset(avio_alloc_context(buffer, buffer_size, 1, this, nullptr, &AvMuxer::write, &AvMuxer::seek));
    if (!io_) {
        av_free(buffer);
        throw std::bad_alloc();
    }
    AVFormatContext* made = nullptr;
    check("write", avformat_alloc_output_context2(&made, nullptr, muxer, nullptr));
    format_.reset(made);
    format_->pb = io_.get();
    format_->flags |= AVFMT_FLAG_BITEXACT;  // no library version, no random IDs
}

AvMuxer::~AvMuxer() {
    if (begun_) av_write_trailer(format_.get());
}

int AvMuxer::begin(AVDictionary** options) {
    const int code = avformat_write_header(format_.get(), options);
    begun_ = code >= 0;
    return code;
}

void AvMuxer::add(AVPacket& packet) {
    check("write to", av_interleaved_write_frame(format_.get(), &packet));
}

void AvMuxer::close() {
    begun_ = false;
    check("finish", av_write_trailer(format_.get()));
    avio_flush(io_.get());
    if (failed_) std::rethrow_exception(failed_);
}

void AvMuxer::check(const char* what, int code) const {
    if (code >= 0) return;
    if (failed_) std::rethrow_exception(failed_);
    fail_(what, code);
}

template <class Byte>
int AvMuxer::write(void* self, Byte* bytes, int size) {
    auto& muxer = *static_cast<AvMuxer*>(self);
    if (muxer.failed_) return AVERROR(EIO);
    try {
        muxer.write_at_(muxer.at_, std::as_bytes(std::span(bytes, static_cast<std::size_t>(size))));
    } catch (...) {
        muxer.failed_ = std::current_exception();
        return AVERROR(EIO);
    }
    muxer.at_ += size;
    muxer.size_ = std::max(muxer.size_, muxer.at_);
    return size;
}

std::int64_t AvMuxer::seek(void* self, std::int64_t offset, int whence) {
    auto& muxer = *static_cast<AvMuxer*>(self);
    if (whence == AVSEEK_SIZE) return muxer.size_;
    const std::int64_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? muxer.at_ : muxer.size_;
    if (base + offset < 0 || base + offset > muxer.size_) return AVERROR(EINVAL);
    return muxer.at_ = base + offset;
}

}  // namespace vvr
