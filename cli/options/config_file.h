#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Config;
}  // namespace CLI

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

    /// Whether the user wants none, whatever the environment or the machine has.
    bool is_refused() const { return is_given && file.empty(); }
};

/// The config file, in order of precedence: --config, the environment variable VVR_CONFIG, the user's file, the
/// system's file. `--config none` or an empty VVR_CONFIG means none. Doesn't check that a named file can be read.
ConfigChoice find_config(std::span<const std::string> arguments);

/// A config file: long option names and values, and sections `[COMMAND]` for one command each. Lines before the first
/// section apply to every command that has the option. A section or name that no command has is an error. A `preset`
/// sets options that the file does not set.
/// \param file for error texts
std::shared_ptr<CLI::Config> config_file_reader(const CLI::App& app, std::string command, std::string file,
                                                NamesOfCommands names);

/// Feeds settings from data to CLI11 in place of a config file. A setting that no option has is an error.
std::shared_ptr<CLI::Config> given_settings_reader(const CLI::App& app,
                                                   std::span<const std::pair<std::string, std::string>> settings);

/// All names of the options that a config file can set.
std::vector<std::string> configurable_names(const CLI::App& app);

}  // namespace vvr::options
