#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/archive/clips.h"
#include "core/footage/recorder_names.h"

// What a camera records from one day's beginning to the next, as one recording.
namespace vvr::archive {

/// When days begin. A day that begins at noon or later is a night: midnight is in its middle, and it has the date of
/// its evening.
struct DayRule {
    std::chrono::minutes begins{0};  ///< after midnight, on the local wall clock
    bool by_container = false;       ///< clips whose names have no time begin when their containers say

    static constexpr std::chrono::minutes noon{12 * 60};

    bool is_night() const { return begins >= noon; }

    friend auto operator<=>(const DayRule&, const DayRule&) = default;
};

/// The date of the day in which a time lies, such as "2026-11-21", in this machine's time zone. A day begins when the
/// wall clock first shows its beginning, or skips it.
/// \param utc seconds since 1970
std::string date_of(std::int64_t utc, const DayRule& rule = {});

/// For people: "2026-11-21", "night of 2026-11-21".
std::string words_of_day(const std::string& date, const DayRule& rule);

/// All clips of a camera that begin on one day.
struct CameraDay {
    std::string camera;                ///< empty = unknown
    std::string date;                  ///< "2026-11-21", in this machine's time zone
    DayRule rule;                      ///< when it begins
    Clip clip;                         ///< the whole day: path of its files, total bytes, time of the newest clip
    std::vector<std::string> files;    ///< below the archive's folder
    std::vector<std::string> undated;  ///< those that are here by their modification times, as nothing else is known
};

/// Clips by camera and day.
struct CameraDays {
    std::vector<CameraDay> days;
    std::vector<ScanProblem> problems;  ///< cameras whose names can't be folder names
    std::size_t waiting = 0;            ///< clips still being written, which are left out
};

/// The beginning of a clip by its name, or by its container if the rule says so; seconds since 1970.
/// \param in the folder of the clips
std::optional<std::int64_t> begin_of_clip(const Clip& clip, const footage::RecorderNames& names, const DayRule& rule,
                                          const std::filesystem::path& in);

/// Groups clips by camera and day. A clip without a known beginning belongs to the day on which it was last written.
/// Pictures need a time in their names, and count only on days without videos.
/// \param in the folder of the clips
CameraDays group_by_day(const std::vector<Clip>& clips, const footage::RecorderNames& names, const Settling& settling,
                        const DayRule& rule = {}, const std::filesystem::path& in = {});

}  // namespace vvr::archive
