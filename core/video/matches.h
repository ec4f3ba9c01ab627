#pragma once

#include <string>
#include <vector>

namespace vvr::video {

/// What a pattern of a shell (`day/*.mp4`) names, in order.
/// \throws Error usage for one that is longer than any path
std::vector<std::string> expand_glob(const std::string& pattern);

}  // namespace vvr::video
