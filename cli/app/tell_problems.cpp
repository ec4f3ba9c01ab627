#include "cli/app/tell_problems.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/words.h"

namespace vvr::app {

void report_warnings(const std::vector<std::string>& warnings, const std::vector<std::string>& problems,
                   Observer& observer) {
    constexpr std::size_t told = 5;  // files; a disk that fails may spoil thousands
    for (const std::string& warning : warnings) observer.warn(warning);
    const std::size_t shown = problems.size() == told + 1 ? problems.size() : std::min(told, problems.size());
    for (std::size_t i = 0; i < shown; ++i) observer.warn(problems[i]);
    if (shown == problems.size()) return;
    observer.warn(fmt::format("{} besides could not be read whole; the report names them",
                              counted(static_cast<std::int64_t>(problems.size() - shown), "file")));
}

void require_whole(const video::VideoInfo& info) {
    if (info.left_out.files == 0) return;
    throw Error(ErrorKind::partial,
                fmt::format("'{}' is not in the result as a whole: {}", info.name, video::text_of(info.left_out)));
}

}  // namespace vvr::app
