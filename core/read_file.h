#pragma once

#include <string>

namespace vvr {

/// All bytes of a file.
/// \throws Error io with the system's reason when it can't be read
std::string read_file(const std::string& path);

}  // namespace vvr
