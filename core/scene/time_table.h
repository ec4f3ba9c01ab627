#pragma once

#include <cstdint>
#include <vector>

#include "core/base/moment.h"
#include "core/bricks/volume.h"

namespace vvr::scene {

/// Which frame of the clip a frame of a volume is, and when it was.
class TimeTable {
  public:
    explicit TimeTable(const bricks::Volume& volume);

    /// The frame nearest to a (fractional) number counted from the volume's first frame; beyond the ends, theirs.
    /// Between the first and the last frame of a layer times are linear, as only those two are known.
    Moment at(double frame) const;

    /// Numbers per layer; of layers of unequal length these are shares of a layer, not frames.
    std::int64_t frames_per_layer() const { return step_; }
    bool empty() const { return layers_.empty(); }

  private:
    struct Entry {
        std::int64_t first_frame = 0;
        std::int64_t last_frame = 0;
        std::int64_t frames = 0;
        double begin = 0;  ///< seconds, of its first frame
        double end = 0;    ///< of its last
    };

    std::int64_t step_;
    bool nonuniform_;
    std::vector<Entry> layers_;
};

}  // namespace vvr::scene
