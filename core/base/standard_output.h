#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace vvr {

/// Whether the name of an output means standard output.
inline bool is_standard_output(const std::filesystem::path& path) {
    return path == "-";
}

/// Writes data for the user. A reader that has seen enough, as `head` has, is no error.
/// \throws Error io
void write_standard_output(std::span<const std::byte> bytes);

}  // namespace vvr
