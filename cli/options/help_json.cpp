#include <cmath>
#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/options/help.h"
#include "cli/options/presets.h"

namespace vvr::options {

namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::string& text) {
    return text.empty() ? Json() : Json(text);
}

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
    Json all = Json::array();
    for (const auto& row : rows) all.push_back({{"name", row.name}, {"help", row.help}});
    return all;
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
    Json examples = Json::array();
    for (const Example& example : help.examples) {
        examples.push_back({{"command", example.command}, {"help", example.what}});
    }
    return {
        {"name", help.name},
        {"help", help.text},
        {"arguments", help.arguments.empty() ? Json() : Json{{"name", help.arguments}, {"help", help.arguments_text}}},
        {"options", std::move(options)},
        {"examples", std::move(examples)}};
}

Json groups_json() {
    Json titles = Json::array();
    for (const Group group : all_groups) titles.push_back(title_of(group));
    return titles;
}

Json value_kinds_json() {
    return named(value_kinds());
}

Json presets_json() {
    Json all = named(presets());
    for (Json& preset : all) {
        preset["options"] = Json::object();
        for (const auto& [name, value] : settings_of_preset(preset["name"].get<std::string>())) {
            preset["options"][std::string(name)] = value;
        }
    }
    return all;
}

}  // namespace vvr::options
