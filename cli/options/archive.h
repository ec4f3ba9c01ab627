#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/archive/shard.h"

namespace vvr {

/// Which clips of an archive are drawn, where to, and what each may take.
struct ArchiveOptions {
    std::filesystem::path in;
    std::filesystem::path out;
    std::vector<std::string> match;  ///< patterns of clips; none = by their endings
    Shard shard;
    std::chrono::seconds settle{60};
    int tries = 3;
    bool dry_run = false;
    bool prune = false;
    bool index_only = false;
    bool no_index = false;
    bool no_pages = false;

    std::optional<int> jobs;  ///< workers at a time; none = as many as cores and memory allow
    std::chrono::seconds timeout{7200};
    std::optional<std::int64_t> max_memory;  ///< bytes a worker; none = its share of the machine's
};

void add_options(CLI::App& app, ArchiveOptions& options);

/// What no single option can know.
/// \throws Error usage
void check(const ArchiveOptions& options);

}  // namespace vvr
