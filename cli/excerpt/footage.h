#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/plan/observer.h"
#include "cli/plan/settings.h"
#include "cli/plan/video_scale.h"
#include "core/base/digest.h"
#include "core/footage/recording.h"
#include "core/footage/unseen.h"
#include "core/image/picture.h"
#include "core/media/frame_source.h"
#include "core/media/frame_span.h"
#include "core/tracking/event.h"

namespace vvr::app {

/// Tells for each moment its file, the seconds in it, and the time of day.
struct MomentPlaces {
    std::span<const media::SegmentPlace> files;  ///< empty = none is told
    const WallClock& clock;

    /// \param seconds of the clip or recording
    nlohmann::ordered_json operator()(double seconds) const;
};

/// What is known of an event that is in a piece. Times are seconds from the first frame of the clip or recording.
struct PieceEvent {
    std::int64_t number = 1;  ///< in the picture, the report and the page
    double first = 0;
    double last = 0;
    std::string kind{};
    std::string what{};                  ///< its class; empty = unknown
    std::optional<double> best{};        ///< when a frame shows it best
    std::optional<PixelBox> box{};       ///< where it was, in pixels of the video
    std::optional<PixelBox> best_box{};  ///< where it is in that frame
};

PieceEvent piece_event(const tracking::Event& event, std::int64_t number, const VideoScale& scale);

/// The span of a piece with everything from `first` to `last`, and `margin` seconds before and after.
media::FrameSpan span_around(double first, double last, double margin);

/// A file listed in a report.
struct ReportedFile {
    media::SegmentPlace place;  ///< in the recording; for a single clip, from 0 without an end
    FileDigest digest;
};

/// The events of a report in the order of their numbers, and the files that contain them.
struct ReportedEvents {
    std::vector<ReportedFile> files;
    std::vector<PieceEvent> events;
    image::Metadata settings{};  ///< of the run that wrote the report
    footage::Unseen unseen{};    ///< the areas that it left out
    std::string camera{};        ///< empty = unknown
};

/// Reads the events from a report of `vvr render --report`.
/// \throws Error io when the file can't be read, usage when it is no such report or has no events
ReportedEvents read_events(const std::filesystem::path& report);

/// One or several files of a recording from which a piece can be cut.
struct Footage {
    footage::Recording recording;  ///< also for a single file
    bool is_single = true;         ///< exactly one file was named
};

/// \throws Error usage for anything but a file with time stamps or a recording of such files
Footage find_footage(const InputOptions& options);

/// The part of a piece that lies in one file.
struct ExcerptFile {
    media::SegmentPlace file;  ///< when it is shown, in seconds of the recording
    media::FrameSpan span;     ///< in seconds or frames of the file
    bool overlaps;             ///< with the previous file
};

/// The times of each file in the recording, from its packets: the same as in a render of the recording. The last is the
/// first file that begins after `until`, if there is one. That file is not read, so only its begin is known.
std::vector<media::SegmentPlace> place_by_packets(const Footage& footage, std::optional<double> until,
                                                  Observer& observer);

/// The times as in a report, for the files that contain the event, and for the available files that the margin reaches
/// into.
/// \param margin seconds before and after the event
/// \throws Error usage when a file of the event is not in the footage, compared by size and digest
std::vector<media::SegmentPlace> place_by_report(const Footage& footage, const ReportedEvents& report,
                                                 const PieceEvent& event, double margin,
                                                 const std::string& report_name);

/// The files that a span reaches into, in order. If files overlap in time, the earlier one is used.
std::vector<ExcerptFile> parts_in(const std::vector<media::SegmentPlace>& places, const media::FrameSpan& span);

}  // namespace vvr::app
