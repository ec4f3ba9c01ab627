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

#include "cli/options/config_choice.h"
#include "cli/options/help.h"
#include "core/base/choice.h"
#include "core/base/setting.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace vvr::options {

/// What a run does with the file that an option may name.
enum class FileUse {
    none,
    read,
    written,
    compared,  ///< read, but written with --bless
};

/// An option with its value as a text.
struct OptionValue {
    std::string name;
    std::string value;
    bool may_be_file = false;
    FileUse use = FileUse::none;

    /// The value without a folder, and an address without its secrets: what is passed on should not say where its maker
    /// keeps files, nor how they get there.
    std::string shown() const;
};

/// What an option has beside its setting.
struct OptionExtra {
    char letter = 0;                  ///< its short name
    std::string help{};               ///< goes on from the setting's
    std::vector<HelpValue> values{};  ///< each with what it does
    std::string defaults{};           ///< what help shows as the default; empty = what files record
    bool standard_output = false;     ///< `-` is standard output, where others would write a file of that name
    FileUse use = FileUse::none;      ///< of what may be a file by its setting: read
};

/// The end of a help text that lists names.
template <class Rows>
std::string list_of(const Rows& rows) {
    return fmt::format(": {}", fmt::join(names_of(rows), ", "));
}

/// The rows of a table as help explains them.
template <class Rows>
std::vector<HelpValue> values_of(const Rows& rows) {
    std::vector<HelpValue> values;
    for (const auto& row : rows) values.push_back({std::string(row.name), std::string(row.help)});
    return values;
}

/// The defaults that a table's rows have for an option: that of the first row, then which rows have another one:
/// "24; temporal: 16; flow: 12". For an option whose default depends on what another one says.
/// \param default_of the text of a row's default
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

/// The command line of one command: its options, a config file for them, and errors in vvr's own words. All that is
/// known of an option is in its Setting; the variable that takes the value holds the default. Given twice, the last
/// value counts, but for files that are written: there two are an error.
class CommandLine {
  public:
    CommandLine(const std::string& command, const std::string& help);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// From now on, settings and rows that a live stream does not have are left out, and refused with the reason.
    void set_for_streams() { for_streams_ = true; }

    /// What is not an option.
    /// \param name as the usage shows it: "INPUT..."
    void arguments(std::vector<std::string>& target, const std::string& name, const std::string& help);

    /// What was given that is not an option.
    std::vector<std::string> arguments() const;

    /// At the end of the help.
    void examples(std::initializer_list<Example> examples);

    /// A number within the setting's range: double, int or std::int64_t, or an optional of these.
    template <class Number>
    void number(Group group, Number& target, const Setting& setting, const OptionExtra& extra = {});

    /// A length of time within the setting's range, in seconds.
    void duration(Group group, double& target, const Setting& setting);

    void text(Group group, std::string& target, const Setting& setting, const OptionExtra& extra = {});
    void path(Group group, std::filesystem::path& target, const Setting& setting, const OptionExtra& extra = {});
    void flag(Group group, bool& target, const Setting& setting, const OptionExtra& extra = {});

    /// Texts that can be given several times.
    void list(Group group, std::vector<std::string>& target, const Setting& setting, const OptionExtra& extra = {});

    /// Any other value.
    /// \param shown the default as the user would type it; empty = none
    /// \param set takes the text that was given; throws Error usage
    void value(Group group, const Setting& setting, const std::string& shown,
               const std::function<void(const std::string&)>& set, const OptionExtra& extra = {});

    /// One row of a table. Help explains the rows.
    /// \param chosen the default's name
    /// \param set takes the row
    template <class Rows, class Set>
    void choice(Group group, const Rows& rows, std::string_view chosen, const Setting& setting, Set set) {
        const auto kept = fitting(rows);
        value(group, setting, std::string(chosen),
              [set, kept, name = setting.name](const std::string& given) { set(choose(name, given, kept)); },
              {.values = values_of(kept)});
    }

    /// The rows of a table that this command has: without those that need the whole clip where there are streams.
    template <class Rows>
    auto fitting(const Rows& rows) const {
        std::vector<std::remove_cvref_t<decltype(*std::begin(rows))>> kept;
        for (const auto& row : rows) {
            if constexpr (requires { row.needs_whole_clip; }) {
                if (for_streams_ && row.needs_whole_clip) continue;
            }
            kept.push_back(row);
        }
        return kept;
    }

    template <class Rows, class Row>
    void choice(Group group, const Rows& rows, Choice<Row>& target, const Setting& setting) {
        choice(group, rows, target->name, setting, [&target](const Row& row) { target = row.name; });
    }

    /// Two options that can't both be given.
    void exclude(const Setting& a, const Setting& b);

    /// What config files may hold for other commands. Without it a config file is for this command alone.
    void set_commands(NamesOfCommands names);

    /// The options that a config file can set.
    std::vector<std::string> configurable() const;

    /// For a command that tells of the config file instead of obeying it.
    void only_find_config();

    /// The config file that is in force, once parsed.
    const ConfigChoice& config() const;

    /// Reads arguments, then the config file for what they leave open: the one that they name, or that is found.
    /// \returns false when help was asked for, and printed
    /// \throws Error usage, or io when the config file can't be read
    bool parse(std::span<const std::string> arguments);

    /// Takes the same as data: no config file is read, and no value is taken for anything else.
    /// \param settings long names of options, and values as one types them; of two with the same name the last one
    /// counts \throws Error usage
    void take(std::vector<std::string> inputs, std::span<const std::pair<std::string, std::string>> settings);

    /// The options of some groups: as given, else the default, which may be empty.
    std::vector<OptionValue> values(std::span<const Group> groups) const;

    /// Those of them that the user gave, on the command line or in a config file.
    std::vector<OptionValue> given(std::span<const Group> groups) const;

    /// Whether the user gave an option.
    bool has(const Setting& setting) const;

  private:
    void refuse_leftovers() const;
    void refuse_two_outputs() const;

    struct Impl;
    std::unique_ptr<Impl> impl_;
    bool for_streams_ = false;
};

}  // namespace vvr::options
