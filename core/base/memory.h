#pragma once

#include <cstdint>
#include <exception>

namespace vvr {

/// Bytes of the machine's memory; 0 or less = unknown.
std::int64_t machine_memory();

/// Whether the process may still have so many bytes more: limits of its own may end before the machine's memory does.
bool is_memory_available(std::int64_t bytes);

/// Has the process keep the memory of the planes that come and go by the frame, instead of giving it back and touching
/// it anew. Larger things go back at once.
void tune_malloc();

/// Gives the system back what the process has freed and kept.
void trim_heap();

/// Whether an exception says that there was no memory, or no thread to be had, which is how a system without memory
/// may say it.
bool is_out_of_memory(const std::exception& error);

/// Calls a function that loads a library, as dlopen does, and as a driver's own functions may. What the library throws
/// as it is loaded, where memory is short, leaves the loader locked, and the next thread that loads one would wait for
/// ever: so it ends the program instead (std::terminate).
template <class Work>
auto while_loading(const Work& work) noexcept {
    return work();
}

}  // namespace vvr
