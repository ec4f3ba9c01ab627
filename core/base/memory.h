#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>

namespace vvr {

/// Bytes of physical memory; 0 or less = unknown.
std::int64_t machine_memory();

/// The lowest memory limit of this process's control group (cgroup v2) and those above it, in bytes: the limit of a
/// container, or of a service of systemd. The greatest number = none.
/// \param membership a file such as /proc/self/cgroup
/// \param groups the folder of the root group
std::int64_t control_group_memory(const std::filesystem::path& membership = "/proc/self/cgroup",
                                  const std::filesystem::path& groups = "/sys/fs/cgroup");

/// The lower of this process's limits on its memory (`ulimit -v` and `-d`), in bytes. The greatest number = none.
std::int64_t own_memory_limit();

/// Whether the process can allocate `bytes` more: its own limits may be lower than the machine's memory.
bool is_memory_available(std::int64_t bytes);

/// Makes malloc keep freed planes and textures for reuse, because returning and faulting in their pages for each frame
/// and each brick is slow; and requests huge pages for its heap. Larger blocks still go back at once.
void tune_malloc();

/// Returns freed memory that malloc has kept to the system.
void trim_heap();

/// Whether an exception means that memory ran out. Failure to start a thread counts: it is how a system may report
/// that.
bool is_out_of_memory(const std::exception& error);

/// Checks that `count` threads can be started at the same time, and ends them. To be called before or after a library
/// starts its own, if it would wait forever for those that it can't start.
/// \throws std::system_error if they can't; `is_out_of_memory` is true for it
void check_threads(unsigned count);

/// Calls a function that may load a library: dlopen or a driver's. If a library throws while it is loaded, for example
/// for lack of memory, the loader stays locked, and the next thread that loads a library waits forever. Therefore an
/// exception ends the program (std::terminate).
template <class Work>
auto while_loading(const Work& work) noexcept {
    return work();
}

}  // namespace vvr
