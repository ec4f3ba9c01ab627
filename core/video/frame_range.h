#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/video/frame_source.h"

namespace vvr {

/// The frames of `source` whose index is at least `first` and below `end`. They are counted as they come, so that it
/// is exact whatever the container says of its rate.
/// \throws Error usage when there is no such frame
std::unique_ptr<FrameSource> limit_frames(std::unique_ptr<FrameSource> source, std::int64_t first,
                                          std::optional<std::int64_t> end);

}  // namespace vvr
