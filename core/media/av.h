#pragma once

#include <atomic>
#include <chrono>
#include <cstdarg>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "core/base/av_muxer.h"
#include "core/media/frame.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

namespace vvr::media {

/// Interrupts blocking reads of a live stream, on request or after a timeout. Readers poll `expired`; all functions may
/// be called from any thread.
class Watchdog {
  public:
    /// \param patience timeout of one read, seconds
    explicit Watchdog(std::chrono::duration<double> patience)
        : patience_(std::chrono::duration_cast<Clock::duration>(patience)) {}

    /// Restarts the timeout. Call it when a read begins.
    void feed() { fed_ = Clock::now(); }

    /// Interrupts the current read and all later ones.
    void stop() { stopped_ = true; }

    bool stopped() const { return stopped_; }
    bool expired() const { return stopped_ || Clock::now() - fed_.load() > patience_; }

  private:
    using Clock = std::chrono::steady_clock;

    Clock::duration patience_;
    std::atomic<Clock::time_point> fed_ = Clock::now();
    std::atomic<bool> stopped_ = false;
};

}  // namespace vvr::media

// RAII owners of libav objects, and libav's error messages.
namespace vvr::media::av {

struct Free : AvFree {
    using AvFree::operator();
    void operator()(AVFormatContext* context) const { avformat_close_input(&context); }
    void operator()(AVBufferRef* buffer) const { av_buffer_unref(&buffer); }
};
template <class T>
using Ptr = std::unique_ptr<T, Free>;

/// Options for libav by name. libav ignores names that it doesn't know.
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

/// \throws Error limit, for a packet
[[noreturn]] void throw_out_of_memory();

/// A packet that shares the data of another one.
/// \throws Error limit when there is no memory
Ptr<AVPacket> copy_of(const AVPacket& packet);

/// The frame's colour space. If unspecified, players assume BT.709 for large pictures and BT.601 for small ones.
AVColorSpace colour_space_of(const AVFrame& frame);

/// An I/O context that calls `read`, and `seek` if it is not null, with `self`.
/// \throws Error limit when there is no memory
Ptr<AVIOContext> make_reader(void* self, int (*read)(void*, std::uint8_t*, int),
                             std::int64_t (*seek)(void*, std::int64_t, int) = nullptr);

/// Collects the errors that libav logs for the attached contexts, and keeps libav off stderr. Each context points to
/// its log, so logs of several threads stay separate.
class Log {
  public:
    /// \param watchdog interrupts the context's reads and must outlive it; none = no timeout
    void attach(AVFormatContext& context, const Watchdog* watchdog = nullptr);
    void attach(AVCodecContext& context);

    /// Records when an attached decoder with one thread can't allocate a frame: some decoders report that as damage.
    static void record_memory(AVCodecContext& context) { context.get_buffer2 = &Log::get_buffer; }

    /// Keeps libav off stderr where nothing is attached.
    static void keep_off_stderr() { av_log_set_callback(&Log::receive); }

    /// Errors that an attached decoder has logged so far are not damage: hardware refused the video.
    static void excuse(AVCodecContext& context);

    /// The last logged error, or else libav's message for `code`.
    std::string text(int code) const;

    /// Whether an error was logged.
    bool has_text() const;

    /// Whether a decoder could not allocate a frame, see `record_memory`.
    bool out_of_memory() const { return out_of_memory_; }

    /// Errors logged so far.
    std::int64_t errors() const;

    /// Errors logged until the last call of `excuse`.
    std::int64_t excused() const { return excused_; }

  private:
    static int interrupted(void* self);
    static int get_buffer(AVCodecContext* context, AVFrame* frame, int flags);
    static void receive(void* context, int level, const char* format, va_list arguments);
    void keep(const std::string& line);

    const Watchdog* watchdog_ = nullptr;
    std::atomic<bool> out_of_memory_ = false;  ///< several decoders may share a log
    std::int64_t excused_ = 0;
    mutable std::mutex mutex_;
    std::string last_;
    std::int64_t errors_ = 0;
};

/// Pictures with more pixels are not decoded. The limit is three 8K frames.
inline constexpr std::int64_t max_pixels = 100'000'000;

}  // namespace vvr::media::av
