#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "cli/console.h"
#include "cli/exit_status.h"
#include "cli/workers/archive_clip.h"
#include "cli/workers/sandbox.h"
#include "cli/workers/worker_message.h"
#include "core/archive/camera_days.h"
#include "core/archive/clips.h"

namespace vvr::workers {

/// What one picture shows.
enum class Grouping { clip, day, night };

struct GroupingRow {
    Grouping grouping;
    std::string_view name;
    std::string_view help;
    bool days;                      ///< the days or nights of a camera
    std::chrono::minutes begins{};  ///< when days begin by default, after midnight
};

inline constexpr std::array groupings{
    GroupingRow{Grouping::clip, "clip", "each clip", false},
    GroupingRow{Grouping::day, "day", "all clips of a camera that begin on a day, as one recording", true},
    GroupingRow{Grouping::night, "night", "the same from noon to noon", true, archive::DayRule::noon},
};

/// What a run writes.
enum class Outputs { pictures, pages, index };

struct OutputsRow {
    Outputs kind;
    std::string_view name;
    std::string_view help;
};

inline constexpr std::array outputs_rows{
    OutputsRow{Outputs::pictures, "pictures", "the pictures, and what vvr records about each clip"},
    OutputsRow{Outputs::pages, "pages", "a page to watch each clip from, and its picture"},
    OutputsRow{Outputs::index, "index", "the index; alone, nothing is drawn"},
};

/// Which clips of an archive to draw, where to, and the limits of a worker.
struct ArchiveOptions {
    std::filesystem::path in;
    std::filesystem::path out;
    std::vector<std::string> match;  ///< patterns of clips' paths; none = video file extensions
    archive::Shard shard;
    std::vector<std::string> exclude;  ///< patterns of files to skip
    Grouping per = Grouping::clip;
    std::optional<archive::DayRule> day{};  ///< when days begin; none = as `per` has it
    bool dry_run = false;
    bool prune = false;
    std::filesystem::path events_to{};           ///< where new events are written; empty = nowhere
    std::filesystem::path events_csv{};          ///< a table of all events; empty = none
    std::optional<std::chrono::seconds> keep{};  ///< how long files are kept; none = for ever
    bool keep_events = false;                    ///< copy each event to a piece beside its page
    double margin = 5;                           ///< seconds before and after a kept event
    std::set<Outputs> write{Outputs::pictures, Outputs::pages, Outputs::index};

    const GroupingRow& grouping() const { return *std::ranges::find(groupings, per, &GroupingRow::grouping); }
    archive::DayRule day_rule() const { return day.value_or(archive::DayRule{grouping().begins}); }
    bool writes(Outputs kind) const { return write.contains(kind); }
    bool draws() const { return writes(Outputs::pictures) || writes(Outputs::pages); }

    PictureSettings pictures;
    std::map<std::string, PictureSettings> of_cameras;  ///< for cameras with settings of their own (`name_of_camera`)
    Settings drawn_with;  ///< the options that select OpenGL and the decoder, for `vvr doctor`
    SandboxMode sandbox = SandboxMode::automatic;
    SandboxNeeds needs;  ///< files and devices that options need

    int threads = 0;          ///< per worker; 0 = its share of the cores
    std::optional<int> jobs;  ///< workers at a time; none = as many as cores and memory allow
    std::chrono::seconds timeout{7200};
    std::optional<std::int64_t> max_memory;  ///< bytes per worker; none = an equal share of 80 % of the memory
};

/// Draws the clips that are new or changed, and writes the index.
/// \returns partial if some clips failed
/// \throws Error usage, io, backend, limit
cli::ExitStatus run_archive(const ArchiveOptions& options, const cli::Environment& environment);

}  // namespace vvr::workers
