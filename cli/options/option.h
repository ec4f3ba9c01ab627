#pragma once

#include <optional>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/options/parse_value.h"
#include "core/error.h"

/// The few ways in which vvr's options are made: long name, unit, default and range, always in the same form.
namespace vvr {

/// Groups of options, as `--help` shows them, in the order in which commands add them.
namespace group {
inline constexpr const char* input = "Input";
inline constexpr const char* fields = "Fields";
inline constexpr const char* bricks = "Bricks";
inline constexpr const char* view = "Layout and view";
inline constexpr const char* look = "Look";
inline constexpr const char* output = "Output";
inline constexpr const char* archive = "Archive";
inline constexpr const char* workers = "Workers";
inline constexpr const char* comparison = "Comparison";
inline constexpr const char* run = "Run";
}  // namespace group

/// How an option is shown.
struct OptionText {
    std::string names;     ///< "--size", "-o,--output"
    std::string unit;      ///< "PIXELS"
    std::string standard;  ///< the default as the user would type it; empty where there is none
    std::string help;
};

/// Adds an option whose text `parse` turns into a value for `target`. Given twice, the last one counts.
template <class Target, class Parse>
CLI::Option* add_option(CLI::App& app, const char* group, Target& target, const OptionText& text, Parse parse) {
    const std::string name = text.names.substr(text.names.find("--"));
    const auto set = [&target, name, parse](const std::string& given) {
        try {
            target = parse(given);
        } catch (const Error& error) {
            throw Error(error.kind(), name + ": " + error.what());
        }
    };
    return app.add_option_function<std::string>(text.names, set, text.help)
        ->type_name(text.unit)
        ->default_str(text.standard)
        ->group(group)
        ->take_last();
}

/// Adds an option for a number; `target` holds the default.
CLI::Option* add_number(CLI::App& app, const char* group, double& target, Range range, OptionText text);

/// Adds an option for a whole number; `target` holds the default.
CLI::Option* add_integer(CLI::App& app, const char* group, int& target, int low, int high, OptionText text);

/// The same for a number that something else decides on when it isn't given; `text.standard` says what.
CLI::Option* add_number(CLI::App& app, const char* group, std::optional<double>& target, Range range, OptionText text);
CLI::Option* add_integer(CLI::App& app, const char* group, std::optional<int>& target, int low, int high,
                         OptionText text);

/// Adds an option whose text is taken as it is; `target` holds the default.
CLI::Option* add_text(CLI::App& app, const char* group, std::string& target, OptionText text);

/// Adds an option for one of `names`; `target` holds the default.
CLI::Option* add_name(CLI::App& app, const char* group, std::string& target, std::vector<std::string> names,
                      OptionText text);

/// The first column of a table, for `add_name` and for suggestions.
template <class Table>
std::vector<std::string> names_of(const Table& table) {
    std::vector<std::string> names;
    names.reserve(std::size(table));
    for (const auto& row : table) names.emplace_back(row.name);
    return names;
}

/// Lists a table's rows at the end of `--help`.
template <class Table>
void explain(CLI::App& app, const std::string& option, const Table& table) {
    std::string rows = "\n" + option + "\n";
    for (const auto& row : table) rows += fmt::format("  {:<14} {}\n", row.name, row.help);
    app.footer(app.get_footer() + rows);
}

/// Adds an option for a name of a table, whose rows are explained; `target` holds the default.
template <class Table>
CLI::Option* add_choice(CLI::App& app, const char* group, std::string& target, const Table& table,
                        const OptionText& text) {
    explain(app, text.names, table);
    return add_name(app, group, target, names_of(table), text);
}

}  // namespace vvr
