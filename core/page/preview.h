#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/image/film.h"

namespace vvr::page {

/// A small film in a file format that browsers play.
struct EncodedVideo {
    std::string type;  ///< "video/mp4"
    std::vector<std::byte> bytes;
    double begin = 0;       ///< seconds of the clip at its beginning
    std::int64_t step = 1;  ///< it shows every `step`-th frame
};

/// The length of a clip as its header says; 0 = unknown.
struct ExpectedLength {
    std::int64_t frames = 0;
    double seconds = 0;
};

/// Makes the preview of a clip frame by frame. Gives up if it can't be both small and useful, or if libav can't encode
/// it: a page is of use without it.
class Preview {
  public:
    static constexpr std::size_t most_bytes = 8'000'000;
    static constexpr std::int64_t most_frames = 6000;  ///< of longer clips only every n-th frame is taken
    static constexpr double least_rate = 2;            ///< pictures per second; with fewer, stills show as much

    /// What a preview is for.
    enum class Use {
        instead,   ///< the browser can't play the clip itself
        fallback,  ///< it can, unless the clip has gone: small
    };

    /// \param clip size of its pictures
    Preview(Size clip, const ExpectedLength& expected, Use use = Use::instead);

    /// Whether there is going to be one, as far as it is known by now.
    bool is_possible() const { return !given_up_; }

    void add(std::int64_t frame, double seconds, const Plane<Bgr>& picture);

    /// Nothing if the clip is too long, or if libav has no encoder for a format that browsers play. Call it once.
    std::optional<EncodedVideo> finish();

    /// What libav said where it could not encode it; empty = it could.
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
