#pragma once

#include <filesystem>

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

}  // namespace vvr
