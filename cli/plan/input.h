#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/plan/observer.h"
#include "cli/plan/plan.h"
#include "cli/plan/settings.h"
#include "core/fields/field_source.h"
#include "core/media/frame_source.h"

namespace vvr::app {

/// The name of an input for pictures and pages: without its folders, which are private, and for a URL without
/// credentials.
std::string shown_name(const std::string& input);

/// The title of a picture and its page: `asked` if not empty, else the clip's name, which data files record.
std::string title_of(const std::string& asked, const media::VideoInfo& clip);

/// The camera of the input: from the archive that draws it, from the user, or from the names of its files. Empty if
/// unknown.
std::string camera_of(const RenderJob& job, const media::VideoInfo& info);

/// Logs all warnings, and some of the problems with files.
void report_warnings(const std::vector<std::string>& warnings, const std::vector<std::string>& problems,
                     Observer& observer);

/// \throws Error partial when files of a recording were left out entirely. Call it last.
void require_whole(const media::VideoInfo& info);

/// The fields of a job.
struct OpenedFields {
    std::unique_ptr<fields::FieldSource> source;
    image::Metadata extracted;            ///< settings fixed by the extraction; empty for a clip
    std::vector<std::string> warnings{};  ///< about the input, one sentence each
    media::FrameSpan span{};              ///< in seconds of the clip
    std::string day_times{};              ///< the wall-clock times of the span, for people; empty = unknown

    ClipFacts facts() const;
};

/// What to compute for each frame.
fields::FieldOptions field_options_of(const RenderJob& job);

/// Whether the fields or the picture need the frames in colour.
bool wants_colour(const RenderJob& job);

/// The input's only clip.
/// \throws Error usage unless exactly one is given
const std::string& only_input(const InputOptions& options);

/// \throws Error usage when no input is given
void require_input(const InputOptions& options);

/// Replaces the seeds by those that the job lists, if any.
/// \param filter of the fields
/// \param compares as in fields::ListedSeeds
std::unique_ptr<fields::FieldSource> with_listed_seeds(std::unique_ptr<fields::FieldSource> fields,
                                                       const RenderJob& job, const fields::FilterRow& filter,
                                                       bool compares);

/// Opens a whole clip, or a recording of several files.
/// \param warnings receives sentences about the input
/// \param layers of the volume, as SourceOptions::layers
std::unique_ptr<media::FrameSource> open_clip(const InputOptions& options, bool colour, int threads,
                                              std::vector<std::string>& warnings, std::int64_t layers = 0);

/// Refuses live streams, as a clip is read to its end, and more than once. Only warns if it can't be known.
/// \throws Error usage for a live stream
void check_has_end(const media::VideoInfo& info, Observer& observer);

/// Converts a span that may have wall-clock times to seconds of the clip.
/// \param day_times receives the wall-clock times, for people; empty = the whole clip, or unknown
/// \throws Error usage when the clock is unknown, or the span has no part of the clip
media::FrameSpan resolve_span(const media::FrameSpan& span, const StartTime& start, const media::VideoInfo& info,
                              std::string& day_times);

/// Opens a clip, a recording, or one or several folders of an extraction in consecutive parts.
/// \throws Error usage also when settings contradict those of the extraction
OpenedFields open_fields(const RenderJob& job);

}  // namespace vvr::app
