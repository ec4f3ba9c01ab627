#pragma once

#include <algorithm>
#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.h"

namespace vvr {

/// The allowed values of a number, both ends included.
struct Range {
    double low = 0;
    double high = 0;
};

/// Describes a setting. The command line, config files, range checks and docs/cli.md use it. The default is the initial
/// value of the setting's variable.
struct Setting {
    std::string_view name;  ///< "min-area"
    std::string_view unit;  ///< or kind of value: "PIXELS"
    std::string_view help;
    Range range{};                       ///< of a number
    std::string_view default_text{};     ///< replaces the default in help: "the filter's"
    bool may_be_file = false;            ///< the value may be the name of a file
    std::string_view not_live_reason{};  ///< why live streams lack the setting; empty = they have it
};

/// \throws Error usage for a number out of the setting's range, NaN too; other values have no range
template <class Value>
void check(const Setting& setting, const Value& found) {
    if constexpr (requires { found.has_value(); }) {
        if (found) check(setting, *found);
    } else if constexpr (std::is_arithmetic_v<Value>) {
        const auto value = static_cast<double>(found);
        if (value >= setting.range.low && value <= setting.range.high) return;
        throw Error(
            ErrorCode::option_value_out_of_range,
            fmt::format("{}: {} is not between {} and {}", setting.name, found, setting.range.low, setting.range.high),
            {setting.name});
    }
}

/// Edit distance (optimal string alignment): insertions, deletions, replacements and swaps of neighbours that turn `a`
/// into `b`.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name closest to `word`, empty if none is close.
std::string nearest_name(std::string_view word, std::span<const std::string> names);

/// ` (did you mean 'NAME'?)` for an error text, or "" if no name is close.
std::string did_you_mean(std::string_view word, std::span<const std::string> names);

/// The names of a table's rows.
template <class Rows>
std::vector<std::string> names_of(const Rows& rows) {
    std::vector<std::string> names;
    for (const auto& row : rows) names.emplace_back(row.name);
    return names;
}

/// \throws Error usage: `setting` can't be `found`; suggests the closest of `names` and lists them all
[[noreturn]] void refuse_choice(std::string_view setting, std::string_view found, std::span<const std::string> names,
                                std::string_view or_else = {});

/// The row with the name `found`.
/// \param setting the setting that chooses the row, for the message
/// \param or_else what else the setting accepts, for the message: ", or the name of a file"
/// \throws Error usage if there is none
template <class Rows>
const auto& choose(std::string_view setting, std::string_view found, const Rows& rows, std::string_view or_else = {}) {
    const auto row = std::ranges::find_if(rows, [&](const auto& r) { return r.name == found; });
    if (row == std::ranges::end(rows)) refuse_choice(setting, found, names_of(rows), or_else);
    return *row;
}

/// The name of a row of that type. `row_of(Name<Row>)`, beside each table, finds the row.
template <class Row>
struct Name {
    std::string_view text;
};

/// A setting that is a row of a table: the name is looked up where it is given, and nowhere else.
template <class Row>
class Choice {
  public:
    Choice(const Row& row) : row_(&row) {}
    Choice(const Row&& row) = delete;  ///< a row belongs to a table
    /// \throws Error usage when no row has the name
    template <std::convertible_to<std::string_view> Text>
    Choice(const Text& name) : row_(&row_of(Name<Row>{name})) {}

    const Row& operator*() const { return *row_; }
    const Row* operator->() const { return row_; }

    friend bool operator==(const Choice&, const Choice&) = default;  ///< whether both are the same row

  private:
    const Row* row_;
};

}  // namespace vvr
