#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>

#include "cli/app/job.h"
#include "cli/app/observer.h"
#include "core/video/frame_span.h"

namespace vvr::app {

/// A piece of a clip or a recording, and where it goes. The piece is an event, or lies between two times.
struct CutJob {
    RenderJob search;                   ///< the footage, its clock, and how events are found in it; nothing is drawn
    std::filesystem::path report;       ///< lists the events instead; empty = they are searched for
    std::optional<std::int64_t> event;  ///< its number, from 1
    std::optional<Time> from;           ///< none = from the beginning
    std::optional<Time> to;             ///< the first frame that is no longer in it; none = to the end
    video::RequestedSpan asked{};       ///< instead of these: by the clock on the wall
    double margin = 0;                  ///< seconds before and after
    bool exact = false;                 ///< encodes the frames of the piece anew, without sound
    std::filesystem::path path;         ///< a file; without an ending, or a folder: the rest of the name is chosen
};

/// Writes the piece. Packets are copied from the key frame before it on, unless it is to be exact.
/// \param stop ends it; nothing is left then
/// \returns false where it was stopped
/// \throws Error usage, io, not_video, limit
bool cut(const CutJob& job, Observer& observer, const std::stop_token& stop);

}  // namespace vvr::app
