#pragma once

#include <cstdint>

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

}  // namespace vvr
