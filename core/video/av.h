#pragma once

#include <atomic>
#include <chrono>
#include <cstdarg>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "core/video/frame.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

namespace vvr::video {

/// Ends reads of a live stream from outside: when somebody asks for it, or when nothing has come for too long. A reader
/// asks `expired`, from any thread.
class Watchdog {
  public:
    /// \param patience how long a read may take
    explicit Watchdog(std::chrono::duration<double> patience)
        : patience_(std::chrono::duration_cast<Clock::duration>(patience)) {}

    /// A read begins now.
    void feed() { fed_ = Clock::now(); }

    /// No read goes on, nor begins any more.
    void stop() { stopped_ = true; }

    bool stopped() const { return stopped_; }
    bool expired() const { return stopped_ || Clock::now() - fed_.load() > patience_; }

  private:
    using Clock = std::chrono::steady_clock;

    Clock::duration patience_;
    std::atomic<Clock::time_point> fed_ = Clock::now();
    std::atomic<bool> stopped_ = false;
};

}  // namespace vvr::video

// Owners of libav's objects, and what libav says of its errors.
namespace vvr::video::av {

struct Free {
    void operator()(AVFormatContext* context) const { avformat_close_input(&context); }
    void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(AVIOContext* context) const;
};
template <class T>
using Ptr = std::unique_ptr<T, Free>;

/// Options for libav by name; what it doesn't know is left alone.
class Dictionary {
  public:
    Dictionary() = default;
    ~Dictionary() { av_dict_free(&entries_); }
    Dictionary(const Dictionary&) = delete;
    Dictionary& operator=(const Dictionary&) = delete;
    Dictionary& operator=(Dictionary&&) = delete;
    Dictionary(Dictionary&& other) noexcept : entries_(std::exchange(other.entries_, nullptr)) {}

    void set(const char* key, const std::string& value) { av_dict_set(&entries_, key, value.c_str(), 0); }
    AVDictionary** get() { return &entries_; }

  private:
    AVDictionary* entries_ = nullptr;
};

/// \throws Error limit when there is no memory
Ptr<AVPacket> make_packet();
AvFrame make_frame();

/// What calls `read` for bytes, and `seek` where there is one, with `self`.
/// \throws Error limit when there is no memory
Ptr<AVIOContext> make_reader(void* self, int (*read)(void*, std::uint8_t*, int),
                             std::int64_t (*seek)(void*, std::int64_t, int) = nullptr);

/// The last error that libav logged on the contexts that carry this log. Nothing of libav's reaches stderr.
/// A context finds its log through its own fields, so decoders in other threads don't mix.
class Log {
  public:
    /// \param watchdog ends the context's reads; none = nothing does. Has to outlive the context.
    void attach(AVFormatContext& context, const Watchdog* watchdog = nullptr);
    void attach(AVCodecContext& context);

    /// The logged text where there is one, else the words for `code`.
    std::string text(int code) const;

    /// Whether there is a logged text.
    bool has_text() const;

    /// Errors logged so far.
    std::int64_t errors() const;

  private:
    static int interrupted(void* self);
    static void receive(void* context, int level, const char* format, va_list arguments);
    void keep(const std::string& line);

    const Watchdog* watchdog_ = nullptr;
    mutable std::mutex mutex_;
    std::string last_;
    std::int64_t errors_ = 0;
};

/// No picture of more pixels is decoded: three times an 8K frame.
inline constexpr std::int64_t max_pixels = 100'000'000;

}  // namespace vvr::video::av
