#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/events/event.h"

namespace vvr::page {

/// A small picture of one frame.
struct Still {
    std::int64_t frame = 0;  ///< index in the clip
    double seconds = 0;
    Plane<Bgr> picture;
};

/// Keeps stills spread evenly over a stream of unknown length. It divides the stream into stretches of equal length and
/// keeps the most active frame of each. When there are too many stretches, it merges neighbours in pairs.
class Stills {
  public:
    /// Maximum number of stills. For at least as many frames, more than half of it are kept.
    static constexpr std::size_t most = 160;

    /// \param size size of the stills
    /// \param most_kept maximum number of stills, even
    explicit Stills(Size size, std::size_t most_kept = most) : size_(size), most_(most_kept) {}

    /// \param activity any measure, such as the number of moving pixels
    void add(std::int64_t frame, double seconds, const Plane<Bgr>& picture, std::int64_t activity);

    /// The stills in order of time. Call it once.
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

/// The most informative still of a clip, with a border around the event that it shows. Events are ranked by kind, then
/// by how long the object stood, then by duration. Without events, it is the middle still.
/// \param field field size; events are in field pixels
/// \returns empty if there are no stills
std::optional<Still> best_still(std::span<const Still> stills, std::span<const events::Event> events, Size field);

}  // namespace vvr::page
