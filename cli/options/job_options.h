#pragma once

#include <array>
#include <filesystem>

#include "cli/options/command_line.h"
#include "cli/plan/settings.h"

// The groups of options that fill a RenderJob.
namespace vvr::options {

/// The groups of options that decide how a picture looks.
inline constexpr std::array picture_groups{Group::input, Group::fields, Group::bricks, Group::view, Group::look};

/// Help texts for INPUT.
inline constexpr const char* video_input =
    "a video file; files, folders, a pattern ('gate/*.mp4') or a list (.txt) of files that are one recording";
inline constexpr const char* clip_input =
    "a video file; files, folders, a pattern ('gate/*.mp4') or a list (.txt) of files that are one recording; a folder "
    "or pattern of pictures (frames/%05d.png); a URL; - for stdin";
inline constexpr const char* clip_or_extraction_input =
    "a video file; files, folders, a pattern ('gate/*.mp4') or a list (.txt) of files that are one recording; a folder "
    "or pattern of pictures (frames/%05d.png); folders that `vvr extract` wrote; a URL; - for stdin";

/// INPUT, and how it is read and decoded.
/// \param name as usage shows it
void add_input_options(CommandLine& line, app::InputOptions& options, const std::string& name, const std::string& help);

/// Patterns that find camera and time in file names.
void add_name_options(CommandLine& line, app::InputOptions& options);

/// Adds the option for the frames that are decoded.
void add_decode_option(CommandLine& line, app::InputOptions& options);

/// INPUT as a clip or the files of a recording, with all of the above, and whether files are accepted as one recording
/// that don't look like one.
void add_recording_options(CommandLine& line, app::InputOptions& options, const std::string& help);

/// The part of the clip to read.
void add_span_options(CommandLine& line, media::FrameSpan& span);

/// The file for the lines of events that have ended.
void add_events_to_option(CommandLine& line, Group group, std::filesystem::path& file);

/// \throws Error usage if the file for the lines is given, but the filter marks no objects
void check_events_to(const std::filesystem::path& file, const app::RenderJob& job);

/// Filter, flow and seeds.
void add_field_options(CommandLine& line, fields::FieldOptions& options);

/// The object detector for events.
void add_detector_option(CommandLine& line, app::DetectorOptions& detector);

/// The option --preset. A preset sets several options; those that the command lacks are skipped.
void add_preset_option(CommandLine& line, Group group);

void add_thread_options(CommandLine& line, int& threads);

/// What decodes video.
void add_hwaccel_option(CommandLine& line, Choice<media::HwaccelRow>& hwaccel);

/// The OpenGL backend and its device.
void add_backend_options(CommandLine& line, app::BackendOptions& backend);

/// All options of a picture or a series, without INPUT and the outputs.
void add_picture_options(CommandLine& line, app::RenderJob& job);

/// Records the settings in the job as text. Call it after parsing.
/// \param series one picture per brick is drawn
/// \throws Error usage when options contradict each other
void finish(const CommandLine& line, app::RenderJob& job, bool series);

/// The record of an extraction's settings, without empty ones. Call it after parsing.
image::Metadata record_of_fields(const CommandLine& line);

void add_output_options(CommandLine& line, app::OutputOptions& options);

/// Which events count. Shared, so that an event has the same number in every command.
void add_event_options(CommandLine& line, Group group, tracking::EventChoice& choice);

/// The allowed difference of two pictures, for `compare` and `render --golden`.
void add_comparison_options(CommandLine& line, app::ComparisonOptions& options);

/// \throws Error usage when the diff's format can't be written, io when its folder can't
void check(const app::ComparisonOptions& options);

/// \throws Error usage when no output is named or outputs contradict each other; io when a folder can't be written
void check(const app::OutputOptions& options);

/// \throws Error usage when an animation would show nothing that moves
void check_outputs(const app::RenderJob& job);

}  // namespace vvr::options
