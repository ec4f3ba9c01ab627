#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/console.h"
#include "cli/exit_status.h"
#include "cli/workers/sandbox.h"
#include "cli/workers/worker_message.h"
#include "core/archive/clips.h"

namespace vvr::workers {

/// What gets a picture.
enum class Grouping { clip, day, both };

struct GroupingRow {
    Grouping grouping;
    std::string_view name;
    std::string_view help;
};

inline constexpr std::array groupings{
    GroupingRow{Grouping::clip, "clip", "each clip"},
    GroupingRow{Grouping::day, "day", "all clips of a camera that begin on a day, as one recording"},
    GroupingRow{Grouping::both, "both", "each clip, and each day of a camera"},
};

/// Which clips of an archive are drawn, where to, and what each may take.
struct ArchiveOptions {
    std::filesystem::path in;
    std::filesystem::path out;
    std::vector<std::string> match;  ///< patterns of clips; none = by their endings
    std::vector<std::string> names;  ///< layouts of clips' names, before those that are known
    archive::Shard shard;
    std::vector<std::string> exclude;  ///< patterns of what is no clip all the same
    Grouping per = Grouping::clip;
    std::chrono::seconds redraw{900};  ///< of a day to which clips are added
    std::chrono::seconds settle{60};
    int tries = 3;
    bool dry_run = false;
    bool prune = false;
    bool index_only = false;
    bool no_index = false;
    bool no_pages = false;

    Settings worker_settings;  ///< of `vvr render`, passed on as they are
    Settings drawn_with;       ///< those of them that choose OpenGL; `vvr doctor` has them too
    SandboxMode sandbox = SandboxMode::automatic;
    SandboxNeeds needs;    ///< of what is passed on
    std::string settings;  ///< changes with everything that decides how pictures look

    int threads = 0;          ///< per worker; 0 = its share of the cores
    std::optional<int> jobs;  ///< workers at a time; none = as many as cores and memory allow
    std::chrono::seconds timeout{7200};
    std::optional<std::int64_t> max_memory;  ///< bytes per worker; none = its share of the machine's
};

/// Draws what is new in an archive, and writes its index.
/// \returns partial where some clips failed
/// \throws Error usage, io, backend, limit
cli::ExitStatus run_archive(const ArchiveOptions& options, const cli::Environment& environment);

}  // namespace vvr::workers
