#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace vvr::options {

/// Groups of options, as `--help` shows them.
enum class Group { output, comparison, archive, workers, input, fields, bricks, view, look, run };

/// All of them, in the order of the help.
inline constexpr std::array all_groups{Group::output, Group::comparison, Group::archive, Group::workers, Group::input,
                                       Group::fields, Group::bricks,     Group::view,    Group::look,    Group::run};

/// The heading of a group.
constexpr const char* title_of(Group group) {
    constexpr const char* titles[] = {"Output", "Comparison", "Archive",         "Workers", "Input",
                                      "Fields", "Bricks",     "Layout and view", "Look",    "Run"};
    return titles[static_cast<int>(group)];
}

/// A value that an option takes, and what it does.
struct HelpValue {
    std::string name;
    std::string help;
};

/// What the help says of an option.
struct HelpOption {
    Group group{};
    char letter = 0;  ///< its short name
    std::string name;
    std::string unit;               ///< what it takes: "PIXELS"; empty for a flag
    std::string text;               ///< with range and default
    std::vector<HelpValue> values;  ///< that a table explains
};

/// A command line that shows what a command is for.
struct Example {
    std::string_view command;
    std::string_view what;
};

/// What the help says of a command.
struct CommandHelp {
    std::string name;
    std::string text;
    std::string arguments;  ///< "INPUT..."; empty = it takes none
    std::string arguments_text;
    std::vector<HelpOption> options;
    std::vector<Example> examples;
};

/// The help of a command: arguments, options by groups, what units mean, examples.
/// \param width columns of a line; only a word that is longer, and an example, goes beyond
std::string help_text(const CommandHelp& help, int width);

/// The columns for help: what the environment's COLUMNS says, else the terminal's, else 80; from 72 to 120.
int help_width();

}  // namespace vvr::options
