#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace vvr::options {

/// A command and the options that a config file can set for it. `options` is called only if a file sets an option that
/// the current command doesn't have.
struct CommandNames {
    std::string command;
    std::function<std::vector<std::string>()> options;
};

/// Returns the names for every command. A function, because only a config file needs them.
using NamesOfCommands = std::function<std::vector<CommandNames>()>;

/// The config file in use, and why.
struct ConfigChoice {
    std::filesystem::path file;                 ///< empty = none
    std::string why;                            ///< for people: "named by --config"
    std::vector<std::filesystem::path> places;  ///< the paths that were tried, in order
    bool is_given = false;                      ///< with --config
};

/// The config file, in order of precedence: --config, the environment variable VVR_CONFIG, the user's file, the
/// system's file. --no-config or an empty VVR_CONFIG means none. Doesn't check that a named file can be read.
ConfigChoice find_config(std::span<const std::string> arguments);

}  // namespace vvr::options
