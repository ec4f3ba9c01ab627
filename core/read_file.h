#pragma once

#include <string>

namespace vvr {

/// Refuses what is there and is no file: a device or a pipe, which may have no end. A pipe that a shell made for a
/// command (`<(...)`) is one.
/// \throws Error io
void check_is_file(const std::string& path);

/// All bytes of a file.
/// \throws Error io with the system's reason when it can't be read
std::string read_file(const std::string& path);

}  // namespace vvr
