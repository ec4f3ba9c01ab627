#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/image/film.h"

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

}  // namespace vvr::page
