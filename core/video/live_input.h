#pragma once

#include <memory>
#include <string>

#include "core/video/input.h"

namespace vvr::video {

/// Finds out what `name` is for one who reads it as it comes: `-` for stdin, a named pipe, a file, a URL, or a camera's
/// device. Nothing is spooled. The name that it has from then on holds no password.
///
/// \throws Error io when it can't be read, or when a named pipe gives nothing within the watchdog's patience, usage for
/// a terminal or a device where libav's devices aren't installed
Input open_live_input(const std::string& name, std::shared_ptr<Watchdog> watchdog);

}  // namespace vvr::video
