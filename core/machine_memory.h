#pragma once

#include <cstdint>

namespace vvr {

/// Bytes of the machine's memory; 0 or less = unknown.
std::int64_t machine_memory();

}  // namespace vvr
