#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/events/event.h"

namespace vvr::page {

/// A small picture of a moment.
struct Still {
    std::int64_t frame = 0;  ///< index in the clip
    double seconds = 0;
    Plane<Bgr> picture;
};

/// Keeps stills spread evenly over a stream of frames of unknown length: the stream is cut into stretches of equal
/// length, and each keeps the frame with most activity. When there are too many stretches, neighbours are joined in
/// pairs.
class Stills {
  public:
    /// Of at least as many frames, more than half as many stills are kept.
    static constexpr std::size_t most = 160;

    /// \param size of the stills
    /// \param most that are kept, an even number
    explicit Stills(Size size, std::size_t most_kept = most) : size_(size), most_(most_kept) {}

    /// \param activity pixels that are not quiet, or any other measure
    void add(std::int64_t frame, double seconds, const Plane<Bgr>& picture, std::int64_t activity);

    /// In order of time. Call it once.
    std::vector<Still> take();

  private:
    struct Kept {
        Still still;
        std::int64_t activity = 0;
    };

    void merge_neighbours();

    Size size_;
    std::size_t most_;
    std::int64_t stretch_ = 1;  ///< frames
    std::int64_t in_last_ = 0;  ///< frames in the last stretch so far
    std::vector<Kept> kept_;
};

/// The still that tells most of a clip, with a frame around what it tells of: of the kind of the best rank, of what
/// stood for longest, of what was there for longest. Without events it is the one in the middle.
/// \param field size of the field, whose pixels are the unit of events
/// \returns nothing where there are no stills
std::optional<Still> best_still(std::span<const Still> stills, std::span<const events::Event> events, Size field);

}  // namespace vvr::page
