#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/app/settings.h"
#include "cli/options/command_line.h"
#include "core/archive/camera_days.h"
#include "core/base/setting.h"
#include "core/events/event.h"
#include "core/image/comparison.h"
#include "core/video/frame_span.h"

// The types that the value of a setting may have. Each has a function that parses it, and one that prints it as a user
// would type it: parsing what was printed gives the same value. Of some types, help lists the possible values.
namespace vvr::options {

// ---- Parsing. Each function throws Error usage with the given text and what was expected.

/// In seconds if the setting's unit is TIME.
void set_value(const Setting& setting, const std::string& text, double& value);
void set_value(const Setting& setting, const std::string& text, int& value);
/// In bytes if the setting's unit is BYTES.
void set_value(const Setting& setting, const std::string& text, std::int64_t& value);
void set_value(const Setting& setting, const std::string& text, std::string& value);
void set_value(const Setting& setting, const std::string& text, std::filesystem::path& value);
void set_value(const Setting& setting, const std::string& text, std::chrono::seconds& value);
void set_value(const Setting& setting, const std::string& text, std::pair<int, int>& share);
void set_value(const Setting& setting, const std::string& text, Size& value);
void set_value(const Setting& setting, const std::string& text, video::Aspect& value);
void set_value(const Setting& setting, const std::string& text, glm::vec4& colour);
void set_value(const Setting& setting, const std::string& text, space::View& direction);
void set_value(const Setting& setting, const std::string& text, image::Tolerance& value);
void set_value(const Setting& setting, const std::string& text, app::Time& value);
void set_value(const Setting& setting, const std::string& text, app::StartTime& value);
void set_value(const Setting& setting, const std::string& text, app::Parts& value);
void set_value(const Setting& setting, const std::string& text, std::optional<app::NamedTransfer>& value);
void set_value(const Setting& setting, const std::string& text, fields::SeedSelection& value);
void set_value(const Setting& setting, const std::string& text, fields::SeedFlags& value);
void set_value(const Setting& setting, const std::string& text, video::DayPart& value);
void set_value(const Setting& setting, const std::string& text, archive::DayRule& value);
void set_value(const Setting& setting, const std::string& text, events::EventChoice& value);
void set_value(const Setting& setting, const std::string& text, const app::FieldSize<Size>& value);
void set_value(const Setting& setting, const std::string& text, const fields::FieldFolder<fields::FieldOptions>& value);
void set_value(const Setting& setting, const std::string& text, const app::SpanStart<video::FrameSpan>& value);
void set_value(const Setting& setting, const std::string& text, const app::SpanEnd<video::FrameSpan>& value);
void set_value(const Setting& setting, const std::string& text, const app::Radii<space::LayoutOptions>& value);
void set_value(const Setting& setting, const std::string& text,
               const app::BackendAndDevice<app::BackendOptions>& value);

template <class Value>
void set_value(const Setting& setting, const std::string& text, std::optional<Value>& value) {
    Value given{};
    set_value(setting, text, given);
    value = std::move(given);
}

template <class Number>
void set_value(const Setting& setting, const std::string& text, const app::NumberOrWord<Number>& value) {
    if (!value.zero.empty() && text == value.zero) {
        value.value = 0;
    } else {
        set_value(setting, text, value.value);
    }
}

// ---- Printing. An empty text means that there is no value.

std::string value_text(const Setting& setting, double value);
std::string value_text(const Setting& setting, int value);
std::string value_text(const Setting& setting, std::int64_t value);
std::string value_text(const Setting& setting, bool value);
std::string value_text(const Setting& setting, const std::string& value);
std::string value_text(const Setting& setting, const std::vector<std::string>& values);
std::string value_text(const Setting& setting, const std::filesystem::path& value);
std::string value_text(const Setting& setting, std::chrono::seconds value);
std::string value_text(const Setting& setting, const std::pair<int, int>& share);
std::string value_text(const Setting& setting, Size value);
std::string value_text(const Setting& setting, const glm::vec4& colour);
std::string value_text(const Setting& setting, const space::View& direction);
std::string value_text(const Setting& setting, const image::Tolerance& value);
std::string value_text(const Setting& setting, const app::Time& value);
std::string value_text(const Setting& setting, const app::StartTime& value);
std::string value_text(const Setting& setting, const app::Parts& value);
std::string value_text(const Setting& setting, const app::NamedTransfer& value);
std::string value_text(const Setting& setting, const fields::SeedSelection& value);
std::string value_text(const Setting& setting, const fields::SeedFlags& value);
std::string value_text(const Setting& setting, const video::Aspect& value);
std::string value_text(const Setting& setting, const video::DayPart& value);
std::string value_text(const Setting& setting, const archive::DayRule& value);
std::string value_text(const Setting& setting, const events::EventChoice& value);
std::string value_text(const Setting& setting, const app::FieldSize<const Size>& value);
std::string value_text(const Setting& setting, const fields::FieldFolder<const fields::FieldOptions>& value);
std::string value_text(const Setting& setting, const app::SpanStart<const video::FrameSpan>& value);
std::string value_text(const Setting& setting, const app::SpanEnd<const video::FrameSpan>& value);
std::string value_text(const Setting& setting, const app::Radii<const space::LayoutOptions>& value);
std::string value_text(const Setting& setting, const app::BackendAndDevice<app::BackendOptions>& value);

inline std::string value_text(const Setting& setting, const app::FieldSize<Size>& value) {
    return value_text(setting, app::FieldSize<const Size>{value.value});
}
inline std::string value_text(const Setting& setting, const fields::FieldFolder<fields::FieldOptions>& value) {
    return value_text(setting, fields::FieldFolder<const fields::FieldOptions>{value.options});
}
inline std::string value_text(const Setting& setting, const app::SpanStart<video::FrameSpan>& value) {
    return value_text(setting, app::SpanStart<const video::FrameSpan>{value.span});
}
inline std::string value_text(const Setting& setting, const app::SpanEnd<video::FrameSpan>& value) {
    return value_text(setting, app::SpanEnd<const video::FrameSpan>{value.span});
}
inline std::string value_text(const Setting& setting, const app::Radii<space::LayoutOptions>& value) {
    return value_text(setting, app::Radii<const space::LayoutOptions>{value.shape});
}

template <class Value>
std::string value_text(const Setting& setting, const std::optional<Value>& value) {
    return value ? value_text(setting, *value) : std::string();
}

template <class Number>
std::string value_text(const Setting& setting, const app::NumberOrWord<Number>& value) {
    return value.value == 0 ? std::string(value.zero) : value_text(setting, value.value);
}

template <class Value>
concept PointsToRow = requires(const Value& value) {
    value->name;
};

template <class Value>
concept KnowsItsName = requires(const Value& value) {
    value.name();
};

/// The name of a table's row, however the value refers to it.
template <class Value>
std::string name_of(const Value& value) {
    if constexpr (PointsToRow<Value>) {
        return std::string(value->name);
    } else if constexpr (KnowsItsName<Value>) {
        return value.name();
    } else {
        return std::string(value.name);
    }
}

/// The name of a row of the table.
template <class Value, class Rows>
std::string value_text(const Setting& /*setting*/, const Value& value, const Rows& /*rows*/) {
    return name_of(value);
}

/// The name of the row with that enumerator.
template <class Value, class Rows, class Row>
std::string value_text(const Setting& /*setting*/, const Value& value, const Rows& rows, Value Row::*member) {
    return std::string(std::ranges::find(rows, value, member)->name);
}

/// A number; if it is not given, the default of the row that another setting chooses.
template <class Value, class Row, class Rows, class Default>
std::string value_text(const Setting& setting, const std::optional<Value>& value, const Row& chosen,
                       const Rows& /*rows*/, Default default_of) {
    return value_text(setting, value ? *value : Value(default_of(chosen)));
}

/// The names of the rows that have one of the enumerators, separated by commas.
template <class Value, class Rows, class Row>
std::string names_in(const std::set<Value>& values, const Rows& rows, Value Row::*member) {
    std::string text;
    for (const auto& row : rows) {
        if (values.contains(row.*member)) text += fmt::format("{}{}", text.empty() ? "" : ",", row.name);
    }
    return text;
}

// ---- Help

/// What the help of an option says beyond the setting, for types that have a fixed set of values.
OptionExtra help_of_values(const app::Parts& value);
OptionExtra help_of_values(const std::optional<app::NamedTransfer>& value);
OptionExtra help_of_values(const events::EventChoice& value);
OptionExtra help_of_values(const app::BackendAndDevice<app::BackendOptions>& value);
template <class Value>
OptionExtra help_of_values(const Value& /*value*/) {
    return {};
}

}  // namespace vvr::options
