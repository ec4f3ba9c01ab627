#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/options/command_line.h"
#include "cli/plan/job.h"
#include "core/base/error.h"

namespace vvr::commands {

/// The file of a folder of golden pictures that says how each is drawn.
inline constexpr const char* golden_list = "golden.toml";

/// How `vvr golden` treats all pictures.
struct GoldenRun {
    std::filesystem::path folder;
    bool bless = false;
    bool diffs = false;  ///< write a picture of the differences beside each golden picture
};

/// One golden picture: what is drawn, and what it is compared with.
struct GoldenCase {
    explicit GoldenCase(std::string name);

    std::string name;  ///< of its section; the picture is NAME.png in the folder
    app::RenderJob job;
    options::CommandLine line;
    std::optional<Error> fault{};  ///< why it can't be drawn
};

/// Reads the folder's list. Every section is a picture; what comes before the first section holds for all of them.
/// \param wanted names of sections; empty = all
/// \param reads out: the list, and all that its pictures are drawn from or compared with
/// \throws Error usage for anything that can't be drawn as it is written; io when the list can't be read
std::vector<std::unique_ptr<GoldenCase>> read_golden_cases(const GoldenRun& run, std::span<const std::string> wanted,
                                                           std::vector<std::string>& reads);

}  // namespace vvr::commands
