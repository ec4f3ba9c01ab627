#include <cmath>
#include <cstdint>
#include <string>

#include "cli/options/help.h"
#include "cli/options/presets.h"
#include "core/base/json_text.h"

namespace vvr::options {

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
