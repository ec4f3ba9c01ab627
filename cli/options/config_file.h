#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/setting.h"

namespace vvr::setting {
inline constexpr Setting preset{"preset", "NAME", "a set of options for a purpose; other options override it"};
}

namespace vvr::options {

/// An option that a preset sets, and its value.
using PresetSetting = std::pair<std::string_view, std::string_view>;

/// A preset: options for a purpose.
struct Preset {
    std::string_view name;
    std::string_view help;
    std::span<const PresetSetting> settings;
    bool needs_whole_clip = false;  ///< not possible for live streams
};

std::span<const Preset> presets();

/// The options that a preset sets; none if there is no such preset.
std::span<const PresetSetting> settings_of_preset(std::string_view name);

/// The option that names a config file.
inline constexpr Setting config_option{
    "config", "FILE",
    "read options from this file, as lines like `size = 1280x800`; the command line takes precedence; none = no file"};

/// A command and the options that a config file can set for it.
struct CommandNames {
    std::string command;
    std::vector<std::string> options;
    std::vector<std::string> camera_options;  ///< those that make sense for one camera
};

/// Returns the names for every command. A function, because only a config file needs them.
using NamesOfCommands = std::function<std::vector<CommandNames>()>;

/// A section of a file that has the format of config files.
struct Section {
    std::string name;                                                          ///< empty = before the first section
    std::vector<std::pair<std::string, std::vector<std::string>>> settings{};  ///< name and values
};

/// Reads a text of that format, without checking its names. The first section is what comes before all others.
/// \param file for error texts
/// \throws Error usage for another format, or a section that is there twice
std::vector<Section> sections_of(const std::string& text, const std::string& file);

/// \throws Error usage as above; io when the file can't be read
std::vector<Section> read_sections(const std::filesystem::path& file);

/// The config file in use, and why.
struct ConfigChoice {
    std::filesystem::path file;                 ///< empty = none
    std::string why;                            ///< for people: "named by --config"
    std::vector<std::filesystem::path> places;  ///< the paths that were tried, in order
    bool is_given = false;                      ///< with --config
};

/// The config file, in order of precedence: --config, the environment variable VVR_CONFIG, the user's file, the
/// system's file. `--config none` or an empty VVR_CONFIG means none. Doesn't check that a named file can be read.
/// \param given with --config
ConfigChoice find_config(const std::optional<std::string>& given);

/// Reads the config file: long option names and values, and sections `[COMMAND]` for one command each. Lines before the
/// first section apply to every command that has the option. Sections `[camera.NAME]` are for one camera and take
/// precedence over both.
/// \throws Error usage for a section or name that no command has; io when the file can't be read
std::vector<Section> read_config(const ConfigChoice& config, const std::vector<CommandNames>& commands);

/// \throws Error usage for a section or name that no command has
void check_sections(std::span<const Section> sections, const std::string& file,
                    const std::vector<CommandNames>& commands);

/// The camera of a section [camera.NAME]; a name may have quotes and dots. Empty for other sections.
std::string camera_of(const Section& section);

/// The cameras that have a section.
std::vector<std::string> cameras_of(std::span<const Section> sections);

/// The camera of all files of the input, which need not be that of an archive: it may have more folders in front. Empty
/// if they differ.
/// \param patterns name patterns that hold
/// \param known cameras that have a section
std::string camera_of_input(const std::vector<std::string>& inputs, const std::vector<std::string>& patterns,
                            std::span<const std::string> known);

}  // namespace vvr::options
