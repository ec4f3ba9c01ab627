#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/archive/sidecar.h"

namespace vvr::archive {

/// Why a clip must be drawn, or why not.
enum class Need {
    nothing,        ///< done
    added,          ///< new
    changed,        ///< its file has changed
    settings,       ///< it was drawn with other settings
    missing,        ///< some of its output files no longer exist
    retry,          ///< it failed, or lacks pieces, and will be tried again
    given_up,       ///< it failed too often
    unread,         ///< a day that lacks files which still can't be opened
    outside,        ///< it has no frame in the span that is drawn
    still_written,  ///< it changed a moment ago
    expired,        ///< it is older than files are kept
    later           ///< a day with new clips that was drawn recently
};

/// The rules of the decision.
struct ArchiveRules {
    std::string settings;           ///< digest of the settings
    std::string version;            ///< version of vvr
    std::vector<OutputKind> files;  ///< kinds of files for each clip
    int tries = 3;
    std::chrono::nanoseconds settle{};
    DayRule day{};                                              ///< when days begin
    std::optional<std::chrono::nanoseconds> keep{};             ///< how long files are kept; none = for ever
    std::chrono::nanoseconds redraw{std::chrono::minutes(15)};  ///< least time between drawings of a growing day
    TryLimits limits{};                                         ///< the least that a worker gets
};

Need need_of(const Clip& clip, const std::optional<Sidecar>& sidecar, const std::filesystem::path& out,
             const ArchiveRules& rules, std::chrono::system_clock::time_point now);

/// The same for a camera day. It is drawn again when clips of `redraw` have been added, or when none has been added for
/// that long; not because clips are gone.
Need need_of_day(const Clip& day, const std::optional<Sidecar>& sidecar, const std::filesystem::path& out,
                 const ArchiveRules& rules, std::chrono::system_clock::time_point now);

/// Whether a clip or a day is older than files are kept, by when its newest file was written. One of the future isn't.
bool is_expired(const Clip& clip, const ArchiveRules& rules, std::chrono::system_clock::time_point now);

/// Whether a clip with this need must be drawn.
bool wants_work(Need need);

/// A name for people, one or two words.
std::string_view name_of(Need need);

}  // namespace vvr::archive
