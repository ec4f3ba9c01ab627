#pragma once

#include <cstdint>

namespace vvr {

/// A frame of the clip and its time.
struct Moment {
    std::int64_t frame = 0;  ///< index in the clip
    double seconds = 0;
};

}  // namespace vvr
