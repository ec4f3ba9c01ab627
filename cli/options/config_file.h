#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/setting.h"

namespace CLI {
class App;
class Config;
}  // namespace CLI

namespace vvr::options {

/// The option that names a config file.
inline constexpr Setting config_option{
    "config", "FILE",
    "read options from this file, as lines like `size = 1280x800`; the command line takes precedence; none = no file"};

/// A command and the options that a config file can set for it. `options` is called only if a file sets an option that
/// the current command doesn't have.
struct CommandNames {
    std::string command;
    std::function<std::vector<std::string>()> options;
    std::function<std::vector<std::string>()> camera_options{};  ///< those that make sense for one camera
};

/// A section of a file that has the format of config files.
struct Section {
    std::string name;                                                          ///< empty = before the first section
    std::vector<std::pair<std::string, std::vector<std::string>>> settings{};  ///< name and values
};

/// Reads such a file, without checking its names. Parts of a section that is continued are joined.
/// \throws Error usage for another format; io when it can't be read
std::vector<Section> read_sections(const std::filesystem::path& file);

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

/// The sections [camera.NAME] of a config file, which have options for the videos of one camera.
struct CameraSections {
    std::vector<std::string> names{};  ///< of all cameras that have a section
    std::string chosen{};              ///< the one whose section holds; empty = none
    std::vector<std::string> sets{};   ///< the options that this section sets
};

/// The camera of a run.
/// \param patterns name patterns that hold: those of the command line, else those of the config file
/// \returns empty if unknown
using FindCamera = std::function<std::string(const std::vector<std::string>& patterns)>;

/// A config file: long option names and values, and sections `[COMMAND]` for one command each. Lines before the first
/// section apply to every command that has the option. Sections `[camera.NAME]` are for one camera and take precedence
/// over both. A section or name that no command has is an error. A `preset` sets options that the file does not set.
/// \param file for error texts
/// \param find_camera tells which section of a camera holds; null = none
/// \param cameras out: the sections of cameras
std::shared_ptr<CLI::Config> config_file_reader(const CLI::App& app, std::string command, std::string file,
                                                NamesOfCommands names, FindCamera find_camera, CameraSections& cameras);

/// Feeds settings from data to CLI11 in place of a config file. A setting that no option has is an error.
std::shared_ptr<CLI::Config> given_settings_reader(const CLI::App& app,
                                                   std::span<const std::pair<std::string, std::string>> settings);

/// All names of the options that a config file can set.
std::vector<std::string> configurable_names(const CLI::App& app);

}  // namespace vvr::options
