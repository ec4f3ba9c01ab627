#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/excerpt/footage.h"
#include "cli/plan/observer.h"
#include "cli/plan/settings.h"
#include "core/footage/segments.h"
#include "core/image/picture_file.h"
#include "core/media/frame_source.h"
#include "core/media/frame_span.h"

// Which part of the footage `vvr cut` cuts: an event, or what is between two times.
namespace vvr::commands {

/// A piece of a clip or a recording, and its output. The piece is an event or lies between two times.
struct CutJob {
    app::RenderJob search;              ///< the footage, its clock, the span, and how to find events; nothing is drawn
    std::filesystem::path report;       ///< a report with the events; empty = search for events
    std::optional<std::int64_t> event;  ///< number of the event in the span, from 1; none = the span is the piece
    double margin = 0;                  ///< seconds before and after
    std::filesystem::path path;         ///< a file, a name without extension, or a folder; missing parts are chosen
    std::filesystem::path evidence;     ///< instead: a new folder for the piece, a still, and where they come from
};

/// The part of the footage that is in the piece.
struct Selection {
    media::FrameSpan span;
    std::vector<media::SegmentPlace> places;      ///< of the files that are at hand
    std::optional<app::PieceEvent> event{};       ///< that is cut
    std::vector<app::PieceEvent> known_events{};  ///< of the report or the search
    image::Metadata settings{};                   ///< with which the event was found
    std::string camera{};                         ///< of the report; empty = unknown
    footage::Unseen unseen{};                     ///< the areas in which nobody looked for events
};

/// Properties of the recording that say when its second 0 was.
/// \param file of the footage
/// \param begin of the file, in seconds of the recording
media::VideoInfo info_of(const app::Footage& footage, const footage::Segment& file, double begin);

/// The job, in which the wall-clock limits of the span are seconds of the recording.
CutJob in_seconds(CutJob job, const app::Footage& footage, app::Observer& observer);

/// The event of the report or of a search, or what is between the limits of the span.
/// \pre `in_seconds` was called
/// \throws Error usage if there is no such event or the piece is empty, io, not_video, limit
Selection select_piece(const CutJob& job, const app::Footage& footage, app::Observer& observer);

}  // namespace vvr::commands
