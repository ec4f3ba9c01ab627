#pragma once

#include <algorithm>
#include <chrono>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/options/help.h"
#include "cli/options/parse_value.h"
#include "cli/plan/settings.h"
#include "core/archive/camera_days.h"
#include "core/base/setting.h"
#include "core/image/comparison.h"
#include "core/media/frame_span.h"
#include "core/tracking/event.h"

// The kinds of value that a setting may have. value_of() is called with a setting and the variable that holds its
// value; the type of the variable decides how text becomes the value, and how the value is printed.
namespace vvr::options {

/// A variable as text.
struct Value {
    enum class Shape { one, flag, list };  ///< a flag needs no text; a list has one for each time that it is given

    std::function<void(const std::string&)> set;  ///< throws Error usage with the text and what was expected
    std::function<std::string()> text;  ///< as a user would type it: set() gives the same value; empty = no value
    Shape shape = Shape::one;
    std::string help{};                ///< what help says beyond the setting
    std::vector<HelpValue> choices{};  ///< the possible values, for help
    std::string defaults{};            ///< default value shown in help; empty = the actual one
    bool is_path = false;
};

Value value_of(const Setting& setting, bool& flag);
/// In seconds if the setting's unit is TIME.
Value value_of(const Setting& setting, double& number, const std::optional<app::Word>& zero = {});
Value value_of(const Setting& setting, int& number, const std::optional<app::Word>& zero = {});
/// In bytes if the setting's unit is BYTES.
Value value_of(const Setting& setting, std::int64_t& number);
Value value_of(const Setting& setting, std::string& text);
Value value_of(const Setting& setting, std::vector<std::string>& texts);
Value value_of(const Setting& setting, std::filesystem::path& path);
Value value_of(const Setting& setting, std::chrono::seconds& length);
/// `2/8`: the second of eight shares.
Value value_of(const Setting& setting, std::pair<int, int>& share);
Value value_of(const Setting& setting, Size& size, app::Word below_zero = {});
Value value_of(const Setting& setting, media::Aspect& aspect);
Value value_of(const Setting& setting, glm::vec4& colour);
Value value_of(const Setting& setting, space::View& view);
Value value_of(const Setting& setting, space::LayoutOptions& radii);
Value value_of(const Setting& setting, image::Tolerance& limits);
Value value_of(const Setting& setting, app::Time& time);
Value value_of(const Setting& setting, app::StartTime& time);
/// The span's start, or its end for the setting `end`.
Value value_of(const Setting& setting, media::FrameSpan& span);
Value value_of(const Setting& setting, media::DayPart& part);
Value value_of(const Setting& setting, archive::DayRule& rule);
Value value_of(const Setting& setting, app::Parts& parts);
Value value_of(const Setting& setting, tracking::EventChoice& choice);
Value value_of(const Setting& setting, std::optional<app::NamedTransfer>& transfer);
Value value_of(const Setting& setting, fields::SeedSelection& selection);
Value value_of(const Setting& setting, fields::SeedFlags& flags);
Value value_of(const Setting& setting, app::BackendOptions& backend);

template <class Type>
Value value_of(const Setting& setting, std::optional<Type>& variable) {
    return {[setting, &variable](const std::string& text) {
                Type given{};
                value_of(setting, given).set(text);
                variable = std::move(given);
            },
            [setting, &variable] { return variable ? value_of(setting, *variable).text() : std::string(); }};
}

/// The rows of a table as values for help.
template <class Rows>
std::vector<HelpValue> values_of(const Rows& rows) {
    std::vector<HelpValue> values;
    for (const auto& row : rows) values.push_back({std::string(row.name), std::string(row.help)});
    return values;
}

/// The names of the rows for which `has` returns true, separated by commas.
template <class Rows, class Has>
std::string names_where(const Rows& rows, Has has) {
    std::string text;
    for (const auto& row : rows) {
        if (has(row)) text += fmt::format("{}{}", text.empty() ? "" : ",", row.name);
    }
    return text;
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

/// A number; if it is not given, the default of the row that another setting chooses.
template <class Number, class Row, class Rows, class Default>
Value value_of(const Setting& setting, std::optional<Number>& variable, const Choice<Row>& chosen, const Rows& rows,
               Default default_of) {
    Value value = value_of(setting, variable);
    value.defaults = defaults_of(rows, [&](const Row& row) { return fmt::to_string(default_of(row)); });
    value.text = [setting, &variable, &chosen, default_of] {
        auto number = variable ? *variable : Number(default_of(*chosen));
        return value_of(setting, number).text();
    };
    return value;
}

/// A row of a table, by its name.
/// \param for_streams leaves out rows that need the whole clip, or files for its frames
/// \param pick called with the row
template <class Rows, class Pick>
Value choice_of(const Setting& setting, const Rows& rows, bool for_streams, Pick pick,
                std::function<std::string()> text) {
    const std::span table(std::data(rows), std::size(rows));
    Value value{.set = {}, .text = std::move(text)};
    for (const auto& row : table) {
        if constexpr (requires { row.needs_whole_clip; }) {
            if (for_streams && row.needs_whole_clip) continue;
        }
        if constexpr (requires { row.traits.given; }) {
            if (for_streams && row.traits.given) continue;
        }
        value.choices.push_back({std::string(row.name), std::string(row.help)});
    }
    value.set = [=, name = setting.name, names = names_of(value.choices)](const std::string& given) {
        if (std::ranges::find(names, given) == names.end()) refuse_choice(name, given, names);
        pick(choose(name, given, table));
    };
    return value;
}

/// The name of a row, or what the variable itself makes of a text, such as the name of a file.
template <class Variable, class Rows>
Value choice_of(const Setting& setting, Variable& variable, const Rows& rows, bool for_streams) {
    if constexpr (requires { variable.or_file; }) {
        Value value = choice_of(
            setting, rows, for_streams, [](const auto&) {}, [&variable] { return variable.name(); });
        value.set = [&variable](const std::string& text) { variable = text; };
        value.help = variable.or_file;
        return value;
    } else {
        return choice_of(
            setting, rows, for_streams, [&variable](const auto& row) { variable = row; },
            [&variable] {
                if constexpr (requires { variable->name; })
                    return std::string(variable->name);
                else
                    return std::string(variable.name);
            });
    }
}

/// The name of the row that has the enumerator.
template <class Enum, class Rows, class Row>
Value choice_of(const Setting& setting, Enum& variable, const Rows& rows, Enum Row::*member) {
    return choice_of(
        setting, rows, false, [&variable, member](const Row& row) { variable = row.*member; },
        [&variable, &rows, member] { return std::string(std::ranges::find(rows, variable, member)->name); });
}

/// The enumerators of some rows, as names separated by commas.
template <class Enum, class Rows, class Row>
Value choice_of(const Setting& setting, std::set<Enum>& variable, const Rows& rows, Enum Row::*member) {
    return {[setting, &variable, &rows, member](const std::string& text) {
                variable.clear();
                for (const std::string& word : split_list(text))
                    variable.insert(choose(setting.name, word, rows).*member);
            },
            [&variable, &rows, member] {
                return names_where(rows, [&](const Row& row) { return variable.contains(row.*member); });
            },
            Value::Shape::one, "", values_of(rows)};
}

}  // namespace vvr::options
