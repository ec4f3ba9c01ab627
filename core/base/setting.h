#pragma once

#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "core/base/error.h"

namespace vvr {

/// The values that a number may have, both ends included.
struct Range {
    double low = 0;
    double high = 0;
};

/// What there is to know of a setting beside its value. The command line, config files, the checks of options and
/// docs/cli.md all read it here. The default is that of the variable that holds the value.
struct Setting {
    std::string_view name;  ///< "min-area"
    std::string_view unit;  ///< what the value is: "PIXELS"
    std::string_view help;
    Range range{};                       ///< of a number
    std::string_view default_text{};     ///< what decides where no value is given: "the filter's"
    bool may_be_file = false;            ///< the value may be the name of a file
    std::string_view not_live_reason{};  ///< why a live stream has no such setting; empty = it has
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

}  // namespace vvr
