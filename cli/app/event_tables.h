#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/plane.h"
#include "core/events/patch.h"

// The events of a clip as tables, for spreadsheets and for tools that evaluate trackers.
namespace vvr::app {

struct RunContext;

/// Where a track was seen in one frame.
struct TrackBox {
    std::int64_t frame = 0;
    std::size_t track = 0;
    PixelBox box;  ///< field pixels
};

/// Adds the boxes of a frame's tracks, each around all pixels of the track.
void add_boxes(const events::FrameLabels& labels, std::vector<TrackBox>& boxes);

/// The text of an `--events-csv` file: a heading, and one line per event. Places are in pixels of the video.
std::string events_table(const RunContext& context);

/// The text of a `--tracks` file in the format of MOT Challenge: frame, number of the event, left, top, width, height,
/// 1, -1, -1, -1. Frames and places count from 1; places are in pixels of the video.
std::string tracks_table(const RunContext& context);

}  // namespace vvr::app
