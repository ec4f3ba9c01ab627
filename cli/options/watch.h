#pragma once

#include "cli/options/command_line.h"
#include "cli/app/watch.h"

namespace vvr {

void add_stream_options(CommandLine& line, StreamOptions& options);

/// What an input names: itself, or, as `@FILE`, the address in the first line of a file. Other users of a machine can
/// read a program's arguments, but not such a file.
/// \throws Error io for a file that can't be read, usage for one without an address
std::string address_of(const std::string& input);

/// The clock of a stream's pictures.
void add_stream_clock(CommandLine& line, StartTime& start);

/// The one option of an output that a stream has.
void add_stream_output(CommandLine& line, OutputOptions& options);

/// \throws Error usage for what only a clip with an end can have
void check_stream(const RenderJob& job);

}  // namespace vvr
