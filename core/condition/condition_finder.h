#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/plane.h"
#include "core/condition/condition.h"
#include "core/condition/edge_map.h"

namespace vvr::condition {

/// What is measured of a frame to tell its condition.
struct FrameSigns {
    std::vector<std::uint8_t> samples;  ///< grey levels, by samples_of
    EdgeMap edges;
    double flat = 0;  ///< share of the samples that lie within three levels of each other
};

/// Every third pixel of every third row.
std::vector<std::uint8_t> samples_of(const Plane<std::uint8_t>& plane);

FrameSigns signs_of(const Plane<std::uint8_t>& grey);

/// Whether a frame shows nothing but a colour, perhaps with a text.
bool is_blank(const FrameSigns& signs);

/// The condition of one frame.
struct Verdict {
    Kind kind = Kind::normal;
    bool repeats = false;  ///< it is the picture before; if that goes on, the recording is frozen
    double since = 0;      ///< seconds; of a frozen recording: when it froze, while its codec still settled
};

/// Tells whether a recording is frozen: frame by frame, from the differences of consecutive pictures.
class FreezeFinder {
  public:
    /// \param samples of the next frame, as in FrameSigns
    Verdict operator()(const std::vector<std::uint8_t>& samples, double seconds);

  private:
    struct Difference {
        double seconds = 0;  ///< of the later picture
        double levels = 0;
    };

    void note_changes(const std::vector<std::uint8_t>& samples, const std::vector<std::uint8_t>& before);
    bool has_noise() const;
    double begin() const;

    std::vector<std::uint8_t> last_;      ///< samples of the frame before
    std::vector<std::uint64_t> changed_;  ///< a bit per strip of samples and recent difference: whether it changed
    int count_ = 0;                       ///< of the differences of pictures that are not repeated
    std::deque<Difference> recent_;       ///< of these pictures, as they are
    std::optional<double> same_since_{};  ///< seconds; the first frame that repeats the one before
};

/// Tells when all of the picture is in another light for a while: the camera's exposure jumps, or a lamp goes on.
class LightFinder {
  public:
    /// \param level of the scene's middle grey in the next frame
    bool operator()(double level, double seconds);

  private:
    struct Level {
        double seconds = 0;
        double level = 0;
    };

    std::deque<Level> recent_;      ///< of the last two seconds in the usual light
    std::optional<Level> usual_{};  ///< theirs, while there is another light since then
};

/// Tells the condition of each frame, in order.
class ConditionFinder {
  public:
    /// \param view how far the frame shows the view of its empty scene; without blocks, nothing is known of that
    /// \param seconds of the clip
    Verdict operator()(const FrameSigns& now, const Agreement& view, double seconds);

  private:
    bool shows_view(const FrameSigns& now, const Agreement& view, double seconds);

    FreezeFinder freeze_;
    EdgeMap known_;        ///< of a frame that showed a known view
    double known_at_ = 0;  ///< seconds
};

}  // namespace vvr::condition
