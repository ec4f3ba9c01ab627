#pragma once

#include <cstdint>
#include <string>

namespace vvr {

/// Bytes that a file of one's own making has at most.
namespace most_bytes {
inline constexpr std::uintmax_t text = std::uintmax_t{16} << 20U;  ///< that people write: settings, points, addresses
inline constexpr std::uintmax_t data = std::uintmax_t{1} << 30U;   ///< that programs write: flow, lists, reports
}  // namespace most_bytes

/// Refuses what is there and is no file: a device or a pipe, which may have no end. A pipe that a shell made for a
/// command (`<(...)`) is one.
/// \param most bytes that it may have
/// \throws Error io, limit for a longer one
void check_is_file(const std::string& path, std::uintmax_t most = UINTMAX_MAX);

/// All bytes of a file.
/// \param most bytes that are read; a file on a disk may say that it has more than the machine
/// \throws Error io with the system's reason when it can't be read, limit when it is longer
std::string read_file(const std::string& path, std::uintmax_t most = most_bytes::data);

}  // namespace vvr
