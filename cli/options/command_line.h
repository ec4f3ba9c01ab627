#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/options/config_file.h"
#include "cli/options/help.h"
#include "cli/options/value.h"
#include "core/base/setting.h"
#include "core/image/picture.h"

namespace vvr::options {

/// What sets an option; of a config file, the lines above all sections, the command's section or the camera's. The
/// later takes precedence.
enum class Source { none, config, section, camera, preset, argument };

constexpr bool is_config(Source source) {
    return source >= Source::config && source <= Source::camera;
}

/// An option and its value as text.
struct OptionValue {
    std::string name;
    std::string value;
    bool may_be_file = false;
    FileUse use = FileUse::none;
    Source source = Source::none;

    /// The value as it may be passed on: a path without its folder, a URL without credentials, so that neither reveals
    /// where files are kept.
    std::string shown() const;
};

/// Properties of an option that neither its Setting nor its value has.
struct OptionExtra {
    char letter = 0;               ///< its short name
    std::string help{};            ///< appended to the setting's help text
    bool standard_output = false;  ///< `-` means standard output; otherwise `-` is an error for an output
    FileUse use = FileUse::none;   ///< for settings that may name a file
};

/// A row of a command: what help says of an option, the variable that it sets, and the texts that are given for it.
struct Option {
    HelpOption help;
    Value value;
    std::string default_value;  ///< as a user would type it; empty = none
    bool may_be_file = false;
    bool refuses_dash = false;           ///< `-` is no file
    std::string_view not_live_reason{};  ///< of an option that a command for streams lacks, else empty
    bool is_configurable = true;
    std::vector<std::string> given{};
    Source source = Source::none;

    bool is_given() const { return !given.empty(); }

    /// Whether the command has the option; not if only workers or only commands for clips have it.
    bool is_visible() const { return help.group != Group::plan && not_live_reason.empty(); }

    /// Replaces texts of a source of lower precedence, and appends to those of the same.
    void give(std::span<const std::string> texts, Source by);

    OptionValue as_text() const;
};

/// The options of one command. Arguments, config files, presets, the plan of a worker and callers of the library all
/// give texts to them; then each option parses the last text into its variable. Help, `vvr config` and the record in
/// files print from the same rows. Two different output files for one option are an error.
class CommandLine {
  public:
    /// \param help what the command does
    CommandLine(std::string command, std::string help);
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// From now on, leaves out settings and rows that a live stream can't have. Giving one is an error with the reason.
    void set_for_streams() { for_streams_ = true; }
    bool is_for_streams() const { return for_streams_; }

    /// The help of the command; only complete when all options have been added.
    CommandHelp help() const;

    /// Adds the positional arguments.
    /// \param name as usage shows them: "INPUT..."
    void arguments(std::vector<std::string>& target, const std::string& name, const std::string& help);

    /// The positional arguments that were given.
    std::vector<std::string> arguments() const;

    /// Examples for the end of the help.
    void examples(std::initializer_list<Example> examples) { help_.examples = examples; }

    /// Adds an option. AddOptions makes the value of a variable.
    void add(Group group, const Setting& setting, Value value, const OptionExtra& extra = {});

    /// Calls `action` after the option has been set.
    void after(const Setting& setting, const std::function<void()>& action);

    /// Adds --help, --config, and --camera-name if the command looks for a camera. Call it last.
    /// \param names of all commands; a config file may set options of any
    void add_common(NamesOfCommands names);

    /// Makes it an error to give both options.
    void exclude(const Setting& a, const Setting& b) { excluded_.emplace_back(a.name, b.name); }

    /// The names of the options that a config file can set.
    std::vector<std::string> configurable(std::span<const Group> groups = all_groups) const;

    /// Finds the config file, but does not apply it. For commands that report on it.
    void only_find_config() { reads_config_ = false; }

    /// The config file in use; known after parse().
    const ConfigChoice& config() const { return config_; }

    /// Applies the config file's section of the input's camera, and lets the user name the camera.
    /// \param found receives the given name, or else that of the section; empty if there is none
    void find_camera(std::string& found) { found_camera_ = &found; }

    /// Applies the config file's section of this camera. parse() throws if there is none.
    void set_camera(const std::string& name) { camera_ = name; }

    /// The cameras that have a section in the config file; known after parse().
    std::vector<std::string> cameras() const { return cameras_of(sections_); }

    /// The camera whose section holds; empty = none.
    const std::string& camera() const { return section_; }

    /// Parses the arguments, then the config file for options that the arguments don't set. The arguments may name the
    /// file; otherwise it is searched for.
    /// \returns false if help was requested and printed
    /// \throws Error usage; io when the config file can't be read
    bool parse(std::span<const std::string> arguments);

    /// Parses the same arguments and config file as another line of the same command, for one camera.
    void parse_for_camera(const CommandLine& parsed, const std::string& camera);

    /// Sets inputs and options from data. Reads no config file, and doesn't interpret values that look like options.
    /// \param settings long option names and values as text; the last of equal names wins
    /// \param of_worker whether they may have options of Group::plan
    /// \throws Error usage
    void take(std::vector<std::string> inputs, std::span<const std::pair<std::string, std::string>> settings,
              bool of_worker = false);

    /// The options of these groups, each with the given or else the default value, which may be empty.
    std::vector<OptionValue> values(std::span<const Group> groups) const;

    /// The options of these groups that the user gave, on the command line or in the config file.
    std::vector<OptionValue> given(std::span<const Group> groups) const;

    /// The values of the variables of these groups, as they may be passed on.
    image::Metadata record(std::span<const Group> groups) const;

    /// Whether the user gave the option. False if the command does not have it.
    bool has(std::string_view name) const;
    bool has(const Setting& setting) const { return has(setting.name); }

    /// Whether the arguments themselves give the option: neither the config file nor a preset. A config file may set
    /// what a run does not use; an argument that changes nothing is an error.
    bool is_argument(std::string_view name) const;

  private:
    std::vector<std::string> read_arguments(std::span<const std::string> arguments);
    void refuse(std::span<const std::string> unknown) const;
    void give(const Section& section, Source source);
    void give_config();
    void give_camera();
    void check_camera() const;
    void give_preset();
    void set_variables();
    void refuse_two_outputs() const;

    CommandHelp help_;
    std::vector<Option> options_{};
    std::vector<std::string>* arguments_ = nullptr;
    std::vector<std::string> inputs_{};  ///< that were given
    std::vector<std::pair<std::string_view, std::string_view>> excluded_{};
    NamesOfCommands names_of_commands_{};
    ConfigChoice config_{};
    bool reads_config_ = true;
    std::vector<Section> sections_{};  ///< of the config file
    std::string camera_{};             ///< that was given
    std::string section_{};
    std::string* found_camera_ = nullptr;
    bool for_streams_ = false;
};

/// Adds an option of the group for each setting that it is called with. The variable holds the default and receives the
/// value. It can visit lists of settings (cli/plan/settings.h), whose further arguments it passes on to
/// cli/options/value.h.
class AddOptions {
  public:
    AddOptions(CommandLine& line, Group group) : line_(line), group_(group) {}

    template <class Variable>
    void operator()(const Setting& setting, Variable& variable, const OptionExtra& extra = {}) const {
        line_.add(group_, setting, value_of(setting, variable), extra);
    }

    template <class Variable>
    void operator()(const Setting& setting, Variable& variable, const app::Word& word) const {
        line_.add(group_, setting, value_of(setting, variable, word));
    }

    /// The name of a row of a table.
    template <class Variable, class Rows>
    void operator()(const Setting& setting, Variable& variable, const Rows& rows) const {
        line_.add(group_, setting, choice_of(setting, variable, rows, line_.is_for_streams()));
    }

    /// The names of rows with an enumerator.
    template <class Variable, class Rows, class Enum, class Row>
    void operator()(const Setting& setting, Variable& variable, const Rows& rows, Enum Row::*member) const {
        line_.add(group_, setting, choice_of(setting, variable, rows, member));
    }

    /// A number whose default is that of a row which another setting chooses.
    template <class Variable, class Row, class Rows, class Default>
    void operator()(const Setting& setting, Variable& variable, const Choice<Row>& chosen, const Rows& rows,
                    Default default_of) const {
        line_.add(group_, setting, value_of(setting, variable, chosen, rows, default_of));
    }

  private:
    CommandLine& line_;
    Group group_;
};

}  // namespace vvr::options
