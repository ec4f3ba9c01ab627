#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <string>

struct AVCodecContext;
struct AVDictionary;
struct AVFormatContext;
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

/// Writes a file with one of libav's muxers: streams that are added to `format`, a header, packets and a trailer. The
/// output is deterministic. libav is C code, so exceptions of `write_at` are kept for `check`.
class AvMuxer {
  public:
    /// Throws an Error that names the file.
    /// \param what "write the header of"
    /// \param code libav's
    using Fail = std::function<void(const char* what, int code)>;

    /// \param muxer libav's name
    /// \throws std::bad_alloc, or what `fail` throws
    AvMuxer(const char* muxer, WriteAt write_at, Fail fail);

    /// Always writes the trailer, because muxers free their last packet only then.
    ~AvMuxer();
    AvMuxer(const AvMuxer&) = delete;
    AvMuxer& operator=(const AvMuxer&) = delete;

    AVFormatContext& format() const { return *format_; }

    /// Size of the file so far, in bytes.
    std::int64_t size() const { return size_; }

    /// Writes the header. \returns libav's code, for `check`
    [[nodiscard]] int begin(AVDictionary** options = nullptr);

    /// Writes a packet of a stream, and takes its data.
    void add(AVPacket& packet);

    /// Writes the trailer, and what is still buffered.
    void close();

    /// \throws whatever `write_at` threw, or else what `fail` throws, if the code is an error
    void check(const char* what, int code) const;

  private:
    struct Free {
        void operator()(AVFormatContext* context) const;
    };

    /// \tparam Byte std::uint8_t; const from FFmpeg 7 on
    template <class Byte>
    static int write(void* self, Byte* bytes, int size);
    static std::int64_t seek(void* self, std::int64_t offset, int whence);

    WriteAt write_at_;
    Fail fail_;
    std::int64_t at_ = 0;
    std::int64_t size_ = 0;
    std::exception_ptr failed_;
    AvPtr<AVIOContext> io_;
    std::unique_ptr<AVFormatContext, Free> format_;
    bool begun_ = false;  ///< the header is written, the trailer is not
};

}  // namespace vvr
