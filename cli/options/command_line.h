#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/options/config_file.h"
#include "cli/options/help.h"
#include "core/base/setting.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace vvr::options {

/// An option and its value as text.
struct OptionValue {
    std::string name;
    std::string value;
    bool may_be_file = false;
    FileUse use = FileUse::none;

    /// The value as it may be passed on: a path without its folder, a URL without credentials, so that neither reveals
    /// where files are kept.
    std::string shown() const;
};

/// Properties of an option that its Setting does not have.
struct OptionExtra {
    char letter = 0;                  ///< its short name
    std::string help{};               ///< appended to the setting's help text
    std::vector<HelpValue> values{};  ///< the possible values, for help
    std::string defaults{};           ///< default value shown in help; empty = the actual one
    bool standard_output = false;     ///< `-` means standard output; otherwise `-` is an error for an output
    FileUse use = FileUse::none;      ///< for settings that may name a file
};

/// The rows of a table as values for help.
template <class Rows>
std::vector<HelpValue> values_of(const Rows& rows) {
    std::vector<HelpValue> values;
    for (const auto& row : rows) values.push_back({std::string(row.name), std::string(row.help)});
    return values;
}

/// The default value of an option that depends on another option's row: that of the first row, then the rows with a
/// different one. For example "24; temporal: 16; flow: 12".
/// \param default_of returns the text of a row's default value
template <class Rows, class Text>
std::string defaults_of(const Rows& rows, Text default_of) {
    std::vector<std::pair<std::string, std::vector<std::string>>> defaults;
    for (const auto& row : rows) {
        const std::string text = default_of(row);
        auto same = std::ranges::find(defaults, text, [](const auto& of) { return of.first; });
        if (same == defaults.end()) same = defaults.insert(defaults.end(), {text, {}});
        same->second.emplace_back(row.name);
    }
    std::string text = defaults.front().first;
    for (const auto& [value, names] : std::span(defaults).subspan(1))
        text += fmt::format("; {}: {}", fmt::join(names, ", "), value);
    return text;
}

/// The command line of one command: its options, its config file, and its error texts. A Setting holds all facts about
/// an option; the target variable holds the default value. If an option is repeated, the last value wins, but two
/// different output files are an error.
class CommandLine {
  public:
    CommandLine(const std::string& command, const std::string& help);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// From now on, leaves out settings and rows that a live stream can't have. Giving one is an error with the reason.
    void set_for_streams() { for_streams_ = true; }

    /// The help of the command; only complete when all options have been added.
    CommandHelp help() const;

    /// Adds the positional arguments.
    /// \param name as usage shows them: "INPUT..."
    void arguments(std::vector<std::string>& target, const std::string& name, const std::string& help);

    /// The positional arguments that were given.
    std::vector<std::string> arguments() const;

    /// Examples for the end of the help.
    void examples(std::initializer_list<Example> examples);

    void flag(Group group, bool& target, const Setting& setting, const OptionExtra& extra = {});

    /// Texts; the option may be repeated.
    void list(Group group, std::vector<std::string>& target, const Setting& setting, const OptionExtra& extra = {});

    /// A value of any other type. AddOptions (cli/options/add_option.h) has the function for each type.
    /// \param shown the default value as a user would type it; empty = none
    /// \param set called with the given text; throws Error usage
    void value(Group group, const Setting& setting, const std::string& shown,
               const std::function<void(const std::string&)>& set, const OptionExtra& extra = {});

    /// The rows that this command can have: for streams, none that need the whole clip, or files for its frames.
    template <class Rows>
    auto fitting(const Rows& rows) const {
        std::vector<std::remove_cvref_t<decltype(*std::begin(rows))>> kept;
        for (const auto& row : rows) {
            if constexpr (requires { row.needs_whole_clip; }) {
                if (for_streams_ && row.needs_whole_clip) continue;
            }
            if constexpr (requires { row.traits.given; }) {
                if (for_streams_ && row.traits.given) continue;
            }
            kept.push_back(row);
        }
        return kept;
    }

    /// A setting that only the plan of a worker sets: no option.
    void plan_setting(const std::string& name, std::function<void(const std::string&)> set);

    /// Makes it an error to give both options.
    void exclude(const Setting& a, const Setting& b);

    /// Lets a config file also set options of these commands. Otherwise it may only set options of this command.
    void set_commands(NamesOfCommands names);

    /// The names of the options that a config file can set.
    std::vector<std::string> configurable() const;

    /// The names of those in these groups.
    std::vector<std::string> configurable(std::span<const Group> groups) const;

    /// Finds the config file, but does not apply it. For commands that report on it.
    void only_find_config();

    /// The config file in use; known after parse().
    const ConfigChoice& config() const;

    /// Applies the config file's section of the input's camera, and lets the user name the camera.
    /// \param found receives the given name, or else that of the section; empty if there is none
    void find_camera(std::string& found);

    /// Applies the config file's section of this camera. parse() throws if there is none.
    void set_camera(const std::string& name);

    /// The config file's sections of cameras; known after parse().
    const CameraSections& cameras() const;

    /// What was parsed.
    std::span<const std::string> parsed() const;

    /// Parses the arguments, then the config file for options that the arguments don't set. The arguments may name the
    /// file; otherwise it is searched for.
    /// \returns false if help was requested and printed
    /// \throws Error usage; io when the config file can't be read
    bool parse(std::span<const std::string> arguments);

    /// Sets inputs and options from data. Reads no config file, and doesn't interpret values that look like options.
    /// \param settings long option names and values as text; the last of equal names wins
    /// \param of_worker whether they may have what plan_setting() adds
    /// \throws Error usage
    void take(std::vector<std::string> inputs, std::span<const std::pair<std::string, std::string>> settings,
              bool of_worker = false);

    /// The options of these groups, each with the given or else the default value, which may be empty.
    std::vector<OptionValue> values(std::span<const Group> groups) const;

    /// The options of these groups that the user gave, on the command line or in the config file.
    std::vector<OptionValue> given(std::span<const Group> groups) const;

    /// Whether the user gave the option. False if the command does not have it.
    bool has(const Setting& setting) const;

    /// Whether the arguments themselves give the option: neither the config file nor a preset. A config file may set
    /// what a run does not use; an argument that changes nothing is an error.
    bool is_argument(std::string_view name) const;

  private:
    std::string camera_of_input(const std::vector<std::string>& patterns) const;
    void refuse_unknown_camera() const;
    void refuse_leftovers() const;
    void refuse_two_outputs() const;

    struct Impl;
    std::unique_ptr<Impl> impl_;
    bool for_streams_ = false;
};

}  // namespace vvr::options
