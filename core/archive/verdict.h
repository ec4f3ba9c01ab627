#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/archive/sidecar.h"

namespace vvr::archive {

/// Why a clip has to be drawn, or why not.
enum class Need {
    nothing,        ///< done
    added,          ///< new
    changed,        ///< its file has changed
    settings,       ///< it was done with other settings
    missing,        ///< some of its output files no longer exist
    retry,          ///< it failed, and is tried again
    given_up,       ///< it failed too often
    still_written,  ///< it changed a moment ago
    later           ///< a day that has more clips by now, and was drawn not long ago
};

/// What the decision depends on.
struct ArchiveRules {
    std::string settings;           ///< digest
    std::string version;            ///< vvr's
    std::vector<OutputKind> files;  ///< that each clip gets
    int tries = 3;
    std::chrono::nanoseconds settle{};
    std::chrono::nanoseconds redraw{};  ///< of a day to which clips are added
};

Need need_of(const Clip& clip, const std::optional<Sidecar>& sidecar, const std::filesystem::path& out,
             const ArchiveRules& rules, std::chrono::system_clock::time_point now);

/// The same for a day of a camera. It is drawn again once clips of `redraw` have been added, or none for as long; not
/// when some have gone.
Need need_of_day(const Clip& day, const std::optional<Sidecar>& sidecar, const std::filesystem::path& out,
                 const ArchiveRules& rules, std::chrono::system_clock::time_point now);

/// Whether a clip with this need has to be drawn.
bool wants_work(Need need);

/// One or two words for people.
std::string_view name_of(Need need);

}  // namespace vvr::archive
