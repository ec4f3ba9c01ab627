#include "cli/options/help.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <sstream>

#include <sys/ioctl.h>
#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/options/config_file.h"
#include "core/base/json_text.h"

namespace vvr::options {

namespace {

constexpr std::size_t column = 30;        // where the text of an option begins
constexpr std::size_t value_column = 15;  // where the text of a value begins, relative to the value's indent

constexpr std::array kinds{
    ValueKind{
        "TIME",
        "12.5s, 3m, 1h30m, 2d or 00:03:00; for positions in a clip and for bricks also 250f, a number of frames. A "
        "number without a unit is in seconds, except where frames are possible: there, a unit is required"},
    ValueKind{
        "AREA",
        "polygons, 'x,y x,y x,y; x,y ...', in pixels of the video from its top left corner; a text file (.txt) with "
        "one polygon per line; or a picture, scaled to the frame, whose levels of 128 and more are the area"},
    ValueKind{"GREY", "grey levels from 0 to 255"},
    ValueKind{"UNITS", "lengths in the picture's space, in which the outer radius of the horseshoe is 1"},
    ValueKind{"LIST", "names separated by commas"},
};

/// Appends words, wrapped; further lines begin at column `indent`.
/// \param at columns already used in the first line
void append_wrapped(std::string& text, std::string_view words, std::size_t indent, std::size_t at, std::size_t width) {
    std::istringstream stream{std::string(words)};
    bool first = true;
    for (std::string word; stream >> word; first = false) {
        if (!first && at + 1 + word.size() > width) {
            text += '\n';
            text.append(indent, ' ');
            at = indent;
        } else if (!first) {
            text += ' ';
            ++at;
        }
        // Break a list that is longer than a line after a comma.
        for (auto comma = word.rfind(',', width - at - 1); at + word.size() > width && comma != std::string::npos;
             comma = word.rfind(',', width - at - 1)) {
            text += word.substr(0, comma + 1) + '\n';
            text.append(indent, ' ');
            at = indent;
            word.erase(0, comma + 1);
        }
        text += word;
        at += word.size();
    }
    text += '\n';
}

/// The text of an option with its range and default value.
std::string text_of(const HelpOption& option) {
    std::string text = option.text;
    const auto& [low, high] = option.range;
    const char* const unit = option.unit == "TIME" ? "s" : "";
    if (low < high) text += fmt::format(" ({}{} to {}{})", low, unit, high, unit);
    if (!option.default_text.empty()) text += fmt::format(" [{}]", option.default_text);
    return text;
}

/// A name at column `from` and its meaning at column `to`.
void append_row(std::string& text, std::string_view name, std::string_view words, std::size_t from, std::size_t to,
                std::size_t width) {
    std::string left(from, ' ');
    left += name;
    if (left.size() + 2 > to) {
        left += '\n';
        left.append(to, ' ');
    }
    left.resize(std::max(left.size(), to), ' ');
    text += left;
    append_wrapped(text, words, to, to, width);
}

void append_option(std::string& text, const HelpOption& option, std::size_t width) {
    std::string names = option.letter == 0 ? "" : fmt::format("-{}, ", option.letter);
    names += "--" + option.name;
    if (!option.unit.empty()) names += " " + option.unit;
    append_row(text, names, text_of(option), 2, column, width);
    for (const HelpValue& value : option.values) {
        append_row(text, value.name, value.help, column + 2, column + 2 + value_column, width);
    }
}

/// What the command does, and how it is called.
std::string heading_of(const CommandHelp& help, std::size_t width) {
    std::string text;
    append_wrapped(text, fmt::format("vvr {}: {}", help.name, help.text), 0, 0, width);
    return text +
           fmt::format("\nUsage: vvr {}{}{} [OPTIONS]\n", help.name, help.arguments.empty() ? "" : " ", help.arguments);
}

/// The groups in which the command has options.
std::vector<Group> groups_of(const CommandHelp& help) {
    std::vector<Group> groups;
    std::ranges::copy_if(all_groups, std::back_inserter(groups), [&](Group group) {
        return std::ranges::find(help.options, group, &HelpOption::group) != help.options.end();
    });
    return groups;
}

bool has_unit(const CommandHelp& help, std::string_view unit) {
    return std::ranges::any_of(help.options, [&](const HelpOption& option) { return option.unit == unit; });
}

}  // namespace

std::span<const ValueKind> value_kinds() {
    return kinds;
}

std::string help_text(const CommandHelp& help, int width) {
    const auto columns = static_cast<std::size_t>(width);
    std::string text = heading_of(help, columns);
    if (!help.arguments.empty()) {
        text += '\n';
        append_row(text, help.arguments, help.arguments_text, 2, column, columns);
    }
    for (const Group group : groups_of(help)) {
        text += fmt::format("\n{}:\n", title_of(group));
        for (const HelpOption& option : help.options) {
            if (option.group == group) append_option(text, option, columns);
        }
    }
    text += "\nDefaults are in brackets, ranges in parentheses.\n";
    for (const ValueKind& kind : kinds) {
        if (has_unit(help, kind.name)) append_row(text, kind.name, kind.help, 2, column, columns);
    }
    if (!help.examples.empty()) text += "\nExamples:\n";
    for (const Example& example : help.examples) text += fmt::format("  # {}\n  {}\n", example.what, example.command);
    return text;
}

std::string short_help_text(const CommandHelp& help, int width) {
    constexpr std::size_t name_column = 16;
    const auto columns = static_cast<std::size_t>(width);
    std::string text = heading_of(help, columns) + '\n';
    for (const Group group : groups_of(help)) {
        std::string names;
        for (const HelpOption& option : help.options) {
            if (option.group != group) continue;
            if (option.letter != 0) names += fmt::format("-{}, ", option.letter);
            names += fmt::format("--{} ", option.name);
        }
        append_row(text, title_of(group), names, 2, name_column, columns);
    }
    if (!help.examples.empty()) text += fmt::format("\nExample: {}\n", help.examples.front().command);
    return text + fmt::format("\n`vvr {} --help` describes all options.\n", help.name);
}

int help_width() {
    constexpr int usual = 80;
    int width = 0;
    const char* const columns = std::getenv("COLUMNS");
    if (columns != nullptr) std::from_chars(columns, columns + std::strlen(columns), width);
    winsize terminal{};
    if (width <= 0 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &terminal) == 0) width = terminal.ws_col;
    return std::clamp(width > 0 ? width : usual, 72, 120);
}

namespace {

/// A whole number without a decimal point.
Json json_of(double number) {
    return number == std::floor(number) ? Json(static_cast<std::int64_t>(number)) : Json(number);
}

Json json_of(const Range& range) {
    return range.low < range.high ? Json{{"low", json_of(range.low)}, {"high", json_of(range.high)}} : Json();
}

Json json_of(FileUse use) {
    switch (use) {
        case FileUse::none:
            return {};
        case FileUse::read:
            return "read";
        case FileUse::written:
            return "written";
        case FileUse::filled:
            return "filled";
        case FileUse::compared:
            return "compared";
    }
    return {};
}

/// Rows that have a name and a help.
template <class Rows>
Json named(const Rows& rows) {
    return list_of(rows, [](const auto& row) { return Json{{"name", row.name}, {"help", row.help}}; });
}

Json json_of(const HelpOption& option) {
    return {{"name", option.name},
            {"short", option.letter == 0 ? Json() : Json(std::string(1, option.letter))},
            {"group", title_of(option.group)},
            {"value", or_null(option.unit)},
            {"help", option.text},
            {"range", json_of(option.range)},
            {"default", or_null(option.default_text)},
            {"choices", named(option.values)},
            {"file", json_of(option.file)},
            {"repeats", option.repeats}};
}

}  // namespace

Json help_json(const CommandHelp& help) {
    Json options = Json::array();
    for (const Group group : all_groups) {
        for (const HelpOption& option : help.options) {
            if (option.group == group) options.push_back(json_of(option));
        }
    }
    const auto example = [](const Example& of) { return Json{{"command", of.command}, {"help", of.what}}; };
    return {
        {"name", help.name},
        {"help", help.text},
        {"arguments", help.arguments.empty() ? Json() : Json{{"name", help.arguments}, {"help", help.arguments_text}}},
        {"options", std::move(options)},
        {"examples", list_of(help.examples, example)}};
}

Json groups_json() {
    return list_of(all_groups, title_of);
}

Json value_kinds_json() {
    return named(value_kinds());
}

Json presets_json() {
    Json all = named(presets());
    for (Json& preset : all) preset["options"] = object_of(settings_of_preset(preset["name"].get<std::string>()));
    return all;
}

}  // namespace vvr::options
