#pragma once

#include <array>

#include "cli/app/job.h"
#include "cli/options/command_line.h"

// The groups of options that fill a RenderJob.
namespace vvr::options {

/// The groups of options that decide how a picture looks.
inline constexpr std::array picture_groups{Group::input, Group::fields, Group::bricks, Group::view, Group::look};

/// Help texts for INPUT.
inline constexpr const char* clip_input =
    "a video file; files, folders, a pattern ('gate/*.mp4') or a list (.txt) of files that are one recording; a folder "
    "or pattern of pictures (frames/%05d.png); a URL; - for stdin";
inline constexpr const char* clip_or_extraction_input =
    "a video file; files, folders, a pattern ('gate/*.mp4') or a list (.txt) of files that are one recording; a folder "
    "or pattern of pictures (frames/%05d.png); folders that `vvr extract` wrote; a URL; - for stdin";

/// INPUT, and how it is read.
/// \param name as usage shows it
void add_input_options(CommandLine& line, app::InputOptions& options, const std::string& name, const std::string& help);

/// Patterns that find camera and time in file names.
void add_name_options(CommandLine& line, app::InputOptions& options);

/// Whether to accept files as one recording that don't look like one.
void add_join_option(CommandLine& line, app::InputOptions& options);

/// The part of the clip to read.
void add_span_options(CommandLine& line, video::FrameSpan& span);

/// Filter, flow and seeds.
void add_field_options(CommandLine& line, fields::FieldOptions& options);

/// Where seeds lie, their order, and their number.
void add_seed_options(CommandLine& line, fields::SeedOptions& options);

/// The option --preset. A preset sets several options; those that the command lacks are skipped.
void add_preset_option(CommandLine& line, Group group);

void add_thread_options(CommandLine& line, int& threads);

/// The OpenGL backend and its device.
void add_backend_options(CommandLine& line, app::BackendOptions& backend);

/// All options of a picture or a series, without INPUT and the outputs.
void add_picture_options(CommandLine& line, app::RenderJob& job);

/// Layout, camera and size of the picture.
void add_view_options(CommandLine& line, app::RenderJob& job);

/// The wall-clock time at the start of the clip.
void add_start_time_option(CommandLine& line, app::StartTime& start);

/// Parses `2026-11-21 08:00:00`, or a word for the time's source.
/// \throws Error usage
app::StartTime parse_start_time(const std::string& text);

/// What the picture shows of the volume and the flow.
void add_look_options(CommandLine& line, app::RenderJob& job);

/// Records the given options in the job as text. Call it after parsing.
/// \param series one picture per brick is drawn
/// \throws Error usage when options contradict each other
void finish(const CommandLine& line, app::RenderJob& job, bool series);

/// Options as recorded in a file's metadata.
image::Metadata shown(const std::vector<OptionValue>& values);

}  // namespace vvr::options
