#pragma once

#include <exception>

namespace vvr {

/// Whether an exception says that there was no memory, or no thread to be had, which is how a system without memory
/// may say it.
bool is_out_of_memory(const std::exception& error);

}  // namespace vvr
