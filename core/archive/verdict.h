#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/archive/sidecar.h"

namespace vvr {

/// What is to become of a clip.
enum class Need {
    nothing,       ///< done
    added,         ///< new
    changed,       ///< its file is another one
    settings,      ///< it was done with other settings
    missing,       ///< of what was done files have gone
    retry,         ///< it failed, and may not the next time
    given_up,      ///< it failed too often
    still_written  ///< it changed a moment ago
};

/// What to go by.
struct ArchiveRules {
    std::string settings;           ///< digest
    std::string version;            ///< vvr's
    std::vector<OutputKind> files;  ///< that each clip gets
    int tries = 3;
    std::chrono::nanoseconds settle{};
};

Need need_of(const Clip& clip, const std::optional<Sidecar>& sidecar, const std::filesystem::path& out,
             const ArchiveRules& rules, std::chrono::system_clock::time_point now);

/// Whether a clip with this need is to be drawn.
bool wants_work(Need need);

/// In a word or two.
std::string_view name_of(Need need);

}  // namespace vvr
