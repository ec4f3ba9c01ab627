#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/base/av_muxer.h"
#include "core/base/plane.h"
#include "core/condition/condition.h"

namespace vvr::media {

// Seconds.
inline constexpr double time_tolerance = 0.0005;  ///< containers round times to milliseconds
inline constexpr double shortest_frame = 0.002;   ///< shorter than any frame, longer than the rounding of two times

struct DecodedFrame;

/// Refers to a frame's decoded picture in full size, for `crop_of`. The picture is there only while the sink of
/// `compute_fields` runs, so frames that are kept longer hold no large buffers.
struct FullSize {
    std::weak_ptr<const DecodedFrame> picture{};  ///< empty for frames without one
    double left = 0;  ///< the frame's left edge in the picture, field pixels; not 0 if a shaking camera is aligned
    double top = 0;
};

/// One decoded image at the field size, with its index in the clip and its presentation time.
struct Frame {
    std::int64_t index = 0;
    double pts = 0;            ///< seconds from the clip's first frame, by the container's timestamps
    Plane<std::uint8_t> grey;  ///< luma
    Plane<Bgr> colour;         ///< same size as `grey`; empty unless requested
    FullSize full_size{};
    condition::Kind before = condition::Kind::no_signal;  ///< why frames before it are missing, if some are
    bool damaged = false;                                 ///< packets were lost, and no key frame has come since
};

/// An immutable frame with several readers.
using SharedFrame = std::shared_ptr<const Frame>;

/// The frame as a colour picture, or as a grey one if it has no colour.
inline Plane<Bgr> picture_of(const Frame& frame) {
    if (!frame.colour.empty()) return frame.colour;
    Plane<Bgr> picture(frame.grey.size());
    std::ranges::transform(frame.grey.pixels(), picture.pixels().begin(), [](std::uint8_t grey) {
        return Bgr{grey, grey, grey};
    });
    return picture;
}

using AvFrame = AvPtr<AVFrame>;

/// The transform that turns a stored picture upright: first transpose, then flip.
struct Orientation {
    bool transpose = false;
    bool flip_x = false;
    bool flip_y = false;

    friend bool operator==(const Orientation&, const Orientation&) = default;
};

/// A decoded frame, cheap to move between threads. A `Scaler` converts it to a `Frame`.
struct DecodedFrame {
    std::int64_t index = 0;
    double pts = 0;  ///< seconds from the clip's first frame
    Orientation orientation;
    AvFrame image;  ///< in the decoder's pixel format and size
    condition::Kind before = condition::Kind::no_signal;
};

}  // namespace vvr::media
