#include "core/video/matches.h"

#include <memory>

#include <glob.h>

#include <climits>
#include <fmt/format.h>

#include "core/base/error.h"

namespace vvr::video {

std::vector<std::string> expand_glob(const std::string& pattern) {
    // The system's function calls itself for each part of a path, however many there are.
    if (pattern.size() >= PATH_MAX) {
        constexpr std::size_t shown = 40;
        throw Error(ErrorKind::usage, fmt::format("'{}...': a pattern has {} bytes at most, as a path has, and this "
                                                  "has {}",
                                                  pattern.substr(0, shown), PATH_MAX - 1, pattern.size()));
    }
    glob_t found{};
    const std::unique_ptr<glob_t, void (*)(glob_t*)> owner(&found, &globfree);
    if (::glob(pattern.c_str(), 0, nullptr, &found) != 0) return {};
    return {found.gl_pathv, found.gl_pathv + found.gl_pathc};
}

}  // namespace vvr::video
