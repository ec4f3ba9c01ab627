#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace vvr::options {

/// A command, and the options of it that a config file can set. They are asked for where a file sets what the command
/// that runs does not have.
struct CommandNames {
    std::string command;
    std::function<std::vector<std::string>()> options;
};

/// Those of every command. A function, as only a config file asks for them.
using NamesOfCommands = std::function<std::vector<CommandNames>()>;

/// Which config file is in force, and why.
struct ConfigChoice {
    std::filesystem::path file;                 ///< empty = none
    std::string why;                            ///< why, as a person would say it: "named by --config"
    std::vector<std::filesystem::path> places;  ///< that were looked at, in turn
    bool is_given = false;                      ///< by --config
};

/// --config of the arguments, else VVR_CONFIG of the environment, else the first of the user's and the machine's that
/// is there. --no-config and an empty VVR_CONFIG mean none. Whether a file that was named can be read is not looked at.
ConfigChoice find_config(std::span<const std::string> arguments);

}  // namespace vvr::options
