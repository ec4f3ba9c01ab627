#pragma once

#include <cstdint>
#include <memory>

struct AVFrame;

namespace vvr {

struct AvFrameFree {
    void operator()(AVFrame* frame) const;
};
using AvFrame = std::unique_ptr<AVFrame, AvFrameFree>;

/// How a stored picture becomes upright: rows and columns swapped first, then mirrored.
struct Orientation {
    bool transpose = false;
    bool flip_x = false;
    bool flip_y = false;

    friend bool operator==(const Orientation&, const Orientation&) = default;
};

/// A frame as it left the decoder: a reference to its buffers, not yet scaled. Cheap to move between threads;
/// a `Scaler` makes the `Frame` of it.
struct DecodedFrame {
    std::int64_t index = 0;
    double pts = 0;  ///< seconds from the clip's first frame
    Orientation orientation;
    AvFrame image;
};

}  // namespace vvr
