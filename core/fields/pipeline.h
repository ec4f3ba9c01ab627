#pragma once

#include <cstdint>
#include <functional>

#include "core/fields/field.h"
#include "core/fields/options.h"
#include "core/video/frame_source.h"

namespace vvr {

/// Receives each frame with its field, in frame order, never from two threads at once.
using FieldSink = std::function<void(Frame&&, Field&&)>;

/// What a pass over a clip found.
struct FieldSummary {
    std::int64_t frames = 0;    ///< frames that reached the sink
    std::int64_t damaged = 0;   ///< packets that could not be decoded
    Plane<std::uint8_t> reference_grey;
    Plane<Bgr> reference_colour;  ///< empty for a source without colour
};

/// Reads every frame of `source` once, in order, and gives its field to `sink`: decoding in order, fields in
/// parallel, `sink` in order (§3's video processing sub-system). Memory doesn't depend on the clip's length.
///
/// \throws Error not_video when not one frame decodes; whatever `sink` throws.
FieldSummary compute_fields(FrameSource& source, const FieldOptions& options, const FieldSink& sink);

}  // namespace vvr
