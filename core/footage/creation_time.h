#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace vvr::footage {

/// When an MP4 or MOV file says that it was created, seconds since 1970 (UTC); nothing for other files. Reads a few
/// numbers of its header itself: only a confined process may give untrusted files to libav.
std::optional<std::int64_t> creation_time_of(const std::filesystem::path& file);

}  // namespace vvr::footage
