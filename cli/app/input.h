#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/app/job.h"
#include "cli/app/observer.h"
#include "core/fields/field_source.h"
#include "core/video/frame_source.h"

namespace vvr::app {

/// What a picture and a page call their clip: an input's name without its folders, which are nobody's business. Of an
/// address neither who may see it is told, nor by what word.
std::string shown_name(const std::string& input);

/// What stands over a picture and its page: what was asked for, else the name of the clip, which data files remember.
std::string title_of(const std::string& asked, const video::VideoInfo& clip);

/// Warns of what was wrong with an input: all warnings, and some of the files' problems.
void report_warnings(const std::vector<std::string>& warnings, const std::vector<std::string>& problems,
                     Observer& observer);

/// \throws Error partial when some files of a recording were left out whole: all else is done by then
void require_whole(const video::VideoInfo& info);

/// What is known of a clip, or of its extracted fields, before the first frame is read.
struct ClipFacts {
    video::VideoInfo info{};
    Size field_size{};
    std::int64_t expected_frames = 0;     ///< 0 = unknown
    image::Metadata extracted{};          ///< as in OpenedFields
    std::vector<std::string> warnings{};  ///< as in OpenedFields
    video::FrameSpan span{};              ///< as in OpenedFields
};

/// The fields that a job works on.
struct OpenedFields {
    std::unique_ptr<fields::FieldSource> source;
    image::Metadata extracted;  ///< settings that were decided when the fields were extracted; empty for a clip
    std::vector<std::string> warnings{};  ///< of the input, a sentence each
    video::FrameSpan span{};              ///< in seconds of the clip
    std::string day_times{};              ///< which times of day these are, for people; empty = nobody knows

    ClipFacts facts() const;
};

/// A clip that was opened had a frame, so it has changed since if it gives none.
/// \throws Error not_video
void require_frames(std::int64_t frames, const video::VideoInfo& info);

/// What is computed of each frame.
fields::FieldOptions field_options_of(const RenderJob& job);

/// The fields need the frames in colour, or the picture shows them.
bool wants_colour(const RenderJob& job);

/// The one clip of an input.
/// \throws Error usage unless there is exactly one
const std::string& only_input(const InputOptions& options);

/// \throws Error usage when there is no input
void require_input(const InputOptions& options);

/// The same fields with the seeds that the job lists, if it does.
/// \param filter of the fields
std::unique_ptr<fields::FieldSource> with_listed_seeds(std::unique_ptr<fields::FieldSource> fields,
                                                       const RenderJob& job, const fields::FilterRow& filter);

/// Opens the whole of a clip, or of a recording of several files.
/// \param warnings what is to be said of it, a sentence each
std::unique_ptr<video::FrameSource> open_clip(const InputOptions& options, bool colour, int threads,
                                              std::vector<std::string>& warnings);

/// A clip is read more than once, and to its end: a live stream can't be.
/// \throws Error usage for a live stream; warns where it can't be known
void check_has_end(const video::VideoInfo& info, Observer& observer);

/// The stretch of a clip that a job reads, where it was asked for by the clock on the wall too.
/// \param day_times which times of day it is, for people; empty = it is the whole clip, or nobody knows
/// \throws Error usage where the clock isn't known, or the clip has nothing of it
video::FrameSpan resolve_span(const video::FrameSpan& span, const StartTime& start, const video::VideoInfo& info,
                              std::string& day_times);

/// Opens a clip, a recording, the directory of an extraction, or several with consecutive parts.
/// \throws Error usage as well where settings contradict those of the extraction
OpenedFields open_fields(const RenderJob& job);

}  // namespace vvr::app
