#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <oneapi/tbb/concurrent_queue.h>

#include "core/base/plane.h"
#include "core/image/video_encoder.h"
#include "core/media/frame.h"

// The small video in a page, which can be watched without the clip.
namespace vvr::page {

/// A small video in a format that browsers play.
struct EncodedVideo {
    std::string type;  ///< MIME type, such as "video/mp4"
    std::vector<std::byte> bytes;
    double begin = 0;       ///< start in the clip, seconds
    std::int64_t step = 1;  ///< has every `step`-th frame of the clip
};

/// The length of a clip according to its header; 0 = unknown.
struct ExpectedLength {
    std::int64_t frames = 0;
    double seconds = 0;
};

/// The encoder of previews that the installed libav has; empty if there is none, and pages have no preview.
std::string_view preview_encoder();

/// Encodes the preview of a clip frame by frame. Gives up if the preview would be too large or too coarse, or if libav
/// fails, because a page also works without it.
class Preview {
  public:
    static constexpr std::size_t most_bytes = 8'000'000;
    static constexpr std::int64_t most_frames = 6000;  ///< longer clips use every n-th frame
    static constexpr double least_rate = 2;            ///< pictures per second; for fewer, stills are enough

    /// The purpose of a preview.
    enum class Use {
        instead,   ///< the browser can't play the clip itself
        fallback,  ///< the browser can play the clip, but the clip may be missing: a small preview
    };

    /// \param clip size of the clip's pictures
    Preview(Size clip, const ExpectedLength& expected, Use use = Use::instead);

    /// False once the preview has been given up.
    bool is_possible() const { return !given_up_; }

    void add(std::int64_t frame, double seconds, const Plane<Bgr>& picture);

    /// The preview. Empty if it was given up, or if libav has no encoder for a format that browsers play. Call it once.
    std::optional<EncodedVideo> finish();

    /// libav's error message if encoding failed, else empty.
    const std::string& problem() const { return problem_; }

  private:
    void begin();
    void encode(std::int64_t frame, double seconds, const Plane<Bgr>& picture);
    void give_up(const std::string& problem);

    Use use_;
    Size size_;
    ExpectedLength expected_;
    std::unique_ptr<image::VideoEncoder> encoder_;
    EncodedVideo video_;
    std::int64_t taken_ = 0;
    std::int64_t first_frame_ = 0;
    std::int64_t last_tick_ = 0;
    bool given_up_ = false;
    std::string problem_;
};

/// Encodes a preview on a thread of its own.
class PreviewThread {
  public:
    /// As Preview.
    PreviewThread(Size clip, const ExpectedLength& expected, Preview::Use use);

    /// Waits for the frames added so far.
    ~PreviewThread();
    PreviewThread(const PreviewThread&) = delete;
    PreviewThread& operator=(const PreviewThread&) = delete;

    /// Whether there may be a preview. Call it before the first frame.
    bool is_possible() const { return preview_.is_possible(); }

    /// Waits while earlier frames are not encoded yet.
    void add(media::SharedFrame frame) { frames_.push(std::move(frame)); }

    /// The preview, as Preview::finish. Call it once.
    std::optional<EncodedVideo> finish();

    /// As Preview::problem. Call it after `finish`.
    const std::string& problem() const { return preview_.problem(); }

  private:
    void encode();
    void end();

    Preview preview_;
    oneapi::tbb::concurrent_bounded_queue<media::SharedFrame> frames_;  ///< null ends the thread
    std::exception_ptr error_;
    std::jthread thread_;  ///< uses the members before it
};

}  // namespace vvr::page
