#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>

#include "cli/app/job.h"
#include "cli/app/observer.h"
#include "core/video/frame_span.h"

namespace vvr::app {

/// A piece of a clip or a recording, and its output. The piece is an event or lies between two times.
struct CutJob {
    RenderJob search;                   ///< the footage, its clock, and how to find events in it; nothing is drawn
    std::filesystem::path report;       ///< a report with the events; empty = search for events
    std::optional<std::int64_t> event;  ///< number of the event, from 1
    std::optional<Time> from;           ///< none = the beginning
    std::optional<Time> to;             ///< the first frame after the piece; none = to the end
    video::RequestedSpan asked{};       ///< wall-clock times, in place of `from` and `to`
    double margin = 0;                  ///< seconds before and after
    bool exact = false;                 ///< encode exactly the frames of the piece, without sound
    std::filesystem::path path;         ///< a file, a name without extension, or a folder; missing parts are chosen
};

/// Writes the piece. Copies packets from the preceding key frame on, unless the piece must be exact.
/// \param stop request to stop; no file is then left
/// \returns false if it was stopped
/// \throws Error usage, io, not_video, limit
bool cut(const CutJob& job, Observer& observer, const std::stop_token& stop);

}  // namespace vvr::app
