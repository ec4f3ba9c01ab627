#pragma once

#include <string>

namespace vvr {

/// The version of the library that runs, for example "0.1.0": it may be newer than the headers.
[[gnu::visibility("default")]] std::string library_version();

}  // namespace vvr
