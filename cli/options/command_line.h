#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/options/find_config.h"
#include "cli/options/group.h"
#include "core/choice.h"
#include "core/setting.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace vvr {

/// An option with its value as a text.
struct OptionValue {
    std::string name;
    std::string value;
    bool may_be_file = false;

    /// The value without a folder: what is passed on should not say where its maker keeps files.
    std::string shown() const;
};

/// What an option has beside its setting.
struct OptionExtra {
    char letter = 0;     ///< its short name
    std::string help{};  ///< goes on from the setting's
};

/// The end of a help text that lists the names of a table's rows.
template <class Rows>
std::string list_of(const Rows& rows) {
    return fmt::format(": {}", fmt::join(names_of(rows), ", "));
}

/// The command line of one command: its options, a config file for them, and errors in vvr's own words. All that is
/// known of an option is in its Setting; the variable that takes the value holds the default. Given twice, the last
/// value counts.
class CommandLine {
  public:
    CommandLine(const std::string& command, const std::string& help);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// What is not an option.
    void arguments(std::vector<std::string>& target, const std::string& name, const std::string& help);

    /// A number within the setting's range: double, int or std::int64_t, or an optional of these.
    template <class Number>
    void number(Group group, Number& target, const Setting& setting, const OptionExtra& extra = {});

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
        explain(setting, rows);
        value(group, setting, std::string(chosen),
              [set, rows, name = setting.name](const std::string& given) { set(choose(name, given, rows)); },
              {.help = list_of(rows)});
    }

    /// The name of one row of a table.
    template <class Rows>
    void choice(Group group, const Rows& rows, std::string& target, const Setting& setting) {
        choice(group, rows, target, setting, [&target](const auto& row) { target = row.name; });
    }

    /// One of some names.
    void name(Group group, std::string& target, const std::vector<std::string>& names, const Setting& setting);

    /// Lists the rows of a table at the end of the help.
    template <class Rows>
    void explain(const Setting& setting, const Rows& rows) {
        std::string text = fmt::format("\n--{}\n", setting.name);
        for (const auto& row : rows) text += fmt::format("  {:<14} {}\n", row.name, row.help);
        add_footer(text);
    }

    /// Two options that can't both be given.
    void exclude(const Setting& a, const Setting& b);

    /// For a command that tells of the config file instead of obeying it.
    void only_find_config();

    /// The config file that is in force, once parsed.
    const ConfigChoice& config() const;

    /// Reads arguments, then the config file for what they leave open: the one that they name, or that is found.
    /// \returns false when help was asked for, and printed
    /// \throws Error usage, or io when the config file can't be read
    bool parse(std::span<const std::string> arguments);

    /// The options of some groups: as given, else the default, which may be empty.
    std::vector<OptionValue> values(std::initializer_list<Group> groups) const;

    /// Those of them that the user gave, on the command line or in a config file.
    std::vector<OptionValue> given(std::initializer_list<Group> groups) const;

    /// Whether the user gave an option.
    bool has(const Setting& setting) const;

  private:
    void add_footer(const std::string& text);
    void refuse_leftovers() const;

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace vvr
