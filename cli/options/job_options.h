#pragma once

#include <array>

#include "cli/app/job.h"
#include "cli/options/command_line.h"

// The groups of options that a RenderJob is made of.
namespace vvr::options {

/// Groups of options that decide how a picture looks.
inline constexpr std::array picture_groups{Group::input, Group::fields, Group::bricks, Group::view, Group::look};

/// What INPUT can be.
inline constexpr const char* clip_input =
    "a video file; files, folders, a pattern ('gate/*.mp4') or a list (.txt) of files that are one recording; a folder "
    "or pattern of pictures (frames/%05d.png); a URL; - for stdin";
inline constexpr const char* clip_or_extraction_input =
    "a video file; files, folders, a pattern ('gate/*.mp4') or a list (.txt) of files that are one recording; a folder "
    "or pattern of pictures (frames/%05d.png); folders that `vvr extract` wrote; a URL; - for stdin";

/// INPUT, and how it is read.
/// \param name as the usage shows it
void add_input_options(CommandLine& line, app::InputOptions& options, const std::string& name, const std::string& help);

/// Patterns by which files' names tell camera and time.
void add_name_options(CommandLine& line, app::InputOptions& options);

/// Whether files are one recording that seem to be none.
void add_join_option(CommandLine& line, app::InputOptions& options);

/// The part of a clip that is read.
void add_span_options(CommandLine& line, video::FrameSpan& span);

/// Filter, flow and seeds.
void add_field_options(CommandLine& line, fields::FieldOptions& options);

/// Where seeds lie, in which order, and how many.
void add_seed_options(CommandLine& line, fields::SeedOptions& options);

/// A set of options for a purpose, of which a command takes those that it has.
void add_preset_option(CommandLine& line, Group group);

void add_thread_options(CommandLine& line, int& threads);

/// What draws: the backend, and its device.
void add_backend_options(CommandLine& line, app::BackendOptions& backend);

/// What one picture or a series is made of, but neither INPUT nor where it goes.
void add_picture_options(CommandLine& line, app::RenderJob& job);

/// Layout, camera and size of the picture.
void add_view_options(CommandLine& line, app::RenderJob& job);

/// What the clock on the wall showed when a clip began.
void add_start_time_option(CommandLine& line, app::StartTime& start);

/// `2026-11-21 08:00:00`, or a word that says who knows it.
/// \throws Error usage
app::StartTime parse_start_time(const std::string& text);

/// What the picture shows of the volume and the flow.
void add_look_options(CommandLine& line, app::RenderJob& job);

/// Puts what was given into the job as texts, after parsing.
/// \param series a picture for each brick is drawn
/// \throws Error usage where options contradict each other
void finish(const CommandLine& line, app::RenderJob& job, bool series);

/// Options as a file of settings records them.
image::Metadata shown(const std::vector<OptionValue>& values);

}  // namespace vvr::options
