#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/base/setting.h"

namespace vvr::options {

/// The groups of options in `--help`.
enum class Group {
    output,
    comparison,
    archive,
    workers,
    input,
    fields,
    bricks,
    view,
    look,
    run,
    plan  ///< no options: only the plan of a worker sets them
};

/// All groups of options, in the order of the help.
inline constexpr std::array all_groups{Group::output, Group::comparison, Group::archive, Group::workers, Group::input,
                                       Group::fields, Group::bricks,     Group::view,    Group::look,    Group::run};

/// The heading of a group.
constexpr const char* title_of(Group group) {
    constexpr const char* titles[] = {"Output", "Comparison", "Archive",         "Workers", "Input",
                                      "Fields", "Bricks",     "Layout and view", "Look",    "Run"};
    return titles[static_cast<int>(group)];
}

/// How a run uses the file that an option names.
enum class FileUse {
    none,
    read,
    written,
    filled,    ///< a folder to which files are added
    compared,  ///< read, or written with --bless
};

/// A possible value of an option, and what it does.
struct HelpValue {
    std::string name;
    std::string help;
};

/// The help of an option.
struct HelpOption {
    Group group{};
    char letter = 0;  ///< its short name
    std::string name;
    std::string unit;          ///< the value's placeholder: "PIXELS"; empty for a flag
    std::string text;          ///< without range and default value
    Range range{};             ///< of a number; none if both ends are equal
    std::string default_text;  ///< as a user would type it; empty = none
    std::vector<HelpValue> values;
    FileUse file{};        ///< whether the value may be a file
    bool repeats = false;  ///< may be given several times
};

/// An example command line and what it does.
struct Example {
    std::string_view command;
    std::string_view what;
};

/// The help of a command.
struct CommandHelp {
    std::string name;
    std::string text;
    std::string arguments;  ///< "INPUT..."; empty = none
    std::string arguments_text;
    std::vector<HelpOption> options;
    std::vector<Example> examples;
};

/// A placeholder that is not self-explanatory: "TIME".
struct ValueKind {
    std::string_view name;
    std::string_view help;
};

std::span<const ValueKind> value_kinds();

/// The help of a command: arguments, options by group, units, examples.
/// \param width columns per line; only examples and very long words exceed it
std::string help_text(const CommandHelp& help, int width);

/// The same on one screen: arguments, the names of the options by group, and an example.
std::string short_help_text(const CommandHelp& help, int width);

/// The width for help, 72 to 120 columns: from the environment variable COLUMNS, else the terminal, else 80.
int help_width();

/// The help of a command for programs. docs/help.schema.json is its schema.
nlohmann::ordered_json help_json(const CommandHelp& help);

/// The titles of the groups, in the order of the help.
nlohmann::ordered_json groups_json();

/// The placeholders that are not self-explanatory.
nlohmann::ordered_json value_kinds_json();

/// The presets, with the options that each sets.
nlohmann::ordered_json presets_json();

}  // namespace vvr::options
