#pragma once

#include "cli/app/watch.h"
#include "cli/options/command_line.h"

namespace vvr::options {

void add_stream_options(CommandLine& line, app::StreamOptions& options);

/// What an input names: itself, or, as `@FILE`, the address in the first line of a file. Other users of a machine can
/// read a program's arguments, but not such a file.
/// \throws Error io for a file that can't be read, usage for one without an address
std::string address_of(const std::string& input);

/// The clock of a stream's pictures.
void add_stream_clock(CommandLine& line, app::StartTime& start);

/// The one option of an output that a stream has.
void add_stream_output(CommandLine& line, app::OutputOptions& options);

/// \throws Error usage for what only a clip with an end can have
void check_stream(const app::RenderJob& job);

}  // namespace vvr::options
