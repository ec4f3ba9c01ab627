#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace vvr {

/// Opens a regular file by its own name. What a link leads to, and what is no file but a FIFO or a device, may be
/// anybody's, and is not waited for.
/// \param flags of open(2), `O_CREAT` among them or not
/// \returns a descriptor, or -1 with `errno`
int open_no_follow(const std::filesystem::path& path, int flags);

/// Locks an open file (`flock`) until its last descriptor is closed.
/// \returns 0, or the error: `EWOULDBLOCK` when somebody else has it
int lock_file(int file, bool wait);

/// Whether `path` is still the name of an open file: who had the lock before may have removed or renamed it.
bool is_same_file(int file, const std::filesystem::path& path);

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

/// Whether the name of an output means standard output.
inline bool is_standard_output(const std::filesystem::path& path) {
    return path == "-";
}

/// Writes data for the user. A reader that has seen enough, as `head` has, is no error.
/// \throws Error io
void write_standard_output(std::span<const std::byte> bytes);

}  // namespace vvr
