#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/plane.h"
#include "core/tracking/patch.h"

namespace vvr::app {

/// Where a track was seen in one frame.
struct TrackBox {
    std::int64_t frame = 0;
    std::size_t track = 0;
    PixelBox box;  ///< field pixels
};

/// Adds the boxes of a frame's tracks, each around all pixels of the track.
void add_boxes(const tracking::FrameLabels& labels, std::vector<TrackBox>& boxes);

}  // namespace vvr::app
