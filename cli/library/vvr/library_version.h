#pragma once

#include <string>

namespace vvr {

/// The version of the loaded library, such as "0.1.0". It may be newer than the headers.
[[gnu::visibility("default")]] std::string library_version();

}  // namespace vvr
