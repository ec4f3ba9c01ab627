#pragma once

#include "cli/app/watch.h"
#include "cli/options/command_line.h"

namespace vvr::options {

void add_stream_options(CommandLine& line, app::StreamOptions& options);

/// The address of an input: the input itself, or for `@FILE` the first line of that file. Other users of the machine
/// can see a program's arguments, but not such a file.
/// \throws Error io when the file can't be read, usage when it holds no address
std::string address_of(const std::string& input);

/// The option --start-time, as streams have it.
void add_stream_clock(CommandLine& line, app::StartTime& start);

/// The output option -o, with the help for streams.
void add_stream_output(CommandLine& line, app::OutputOptions& options);

/// \throws Error usage for options that need a clip with an end
void check_stream(const app::RenderJob& job);

}  // namespace vvr::options
