#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <string>

struct AVCodecContext;
struct AVFrame;
struct AVIOContext;
struct AVPacket;
struct SwsContext;

namespace vvr {

/// Owners of libav's objects.
struct AvFree {
    void operator()(AVCodecContext* context) const;
    void operator()(AVFrame* frame) const;
    void operator()(AVIOContext* context) const;  ///< and its buffer
    void operator()(AVPacket* packet) const;
    void operator()(SwsContext* context) const;
};
template <class T>
using AvPtr = std::unique_ptr<T, AvFree>;

/// libav's words for one of its errors.
std::string av_error_text(int error);

/// Writes bytes at an offset of a file, over existing bytes. A gap after the file's end is filled with zeros.
using WriteAt = std::function<void(std::int64_t offset, std::span<const std::byte> bytes)>;

/// The output of libav's muxers. They are C code, so exceptions of `write_at` are kept for `check`.
class AvWriter {
  public:
    /// \throws std::bad_alloc
    explicit AvWriter(WriteAt write_at);
    ~AvWriter();
    AvWriter(const AvWriter&) = delete;
    AvWriter& operator=(const AvWriter&) = delete;

    AVIOContext* context() const { return context_.get(); }

    /// Size of the file so far, in bytes.
    std::int64_t size() const { return size_; }

    /// Writes what is still buffered.
    /// \throws whatever `write_at` threw
    void flush();

    /// \throws whatever `write_at` threw; otherwise does nothing
    void check() const;

  private:
    /// \tparam Byte std::uint8_t; const from FFmpeg 7 on
    template <class Byte>
    static int write(void* self, Byte* bytes, int size);
    static std::int64_t seek(void* self, std::int64_t offset, int whence);

    WriteAt write_at_;
    std::int64_t at_ = 0;
    std::int64_t size_ = 0;
    std::exception_ptr failed_;
    AvPtr<AVIOContext> context_;
};

}  // namespace vvr
