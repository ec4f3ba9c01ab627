#include "cli/options/presets.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace vvr::options {

namespace {

constexpr std::array<std::string_view, 6> day{"--time",
                                              "busy",
                                              "--brick",
                                              "01:00:00",
                                              "--show",
                                              "volume,portraits,map,strip,numbers,directions,outline,ribs,frames,ends,"
                                              "ruler,legend,title,explanation,bricks"};

// The paper's method and figures; default values where the paper gives none.
constexpr std::array<std::string_view, 36> paper{
    "--illumination",  "none",          // colour and light unchanged
    "--shadows",       "keep",          //
    "--stabilize",     "off",           //
    "--flow",          "horn-schunck",  // §4.1: 60 steps with λ = 100, which is α²; the derivatives of [BFB94]
    "--solver",        "jacobi",        //
    "--iterations",    "60",            //
    "--alpha",         "10",            //
    "--derivatives",   "barron",        //
    "--seed-area",     "object",        // §4.2: by the flow and the difference object, the fastest first
    "--seed-order",    "magnitude",     //
    "--layout",        "horseshoe",     // §5.1
    "--time-velocity", "0",             // §5.2
    "--theme",         "light",         // the figures: dark objects on white, arrows from yellow to red, no text
    "--color",         "transfer",      //
    "--transfer",      "grey",          //
    "--shading",       "none",          //
    "--show",          "volume,arrows",
    "--background",    "#ffffff"};

constexpr std::array table{
    Preset{"day", "a recording of many hours: more room for motion, one brick per hour", day, true},
    Preset{"paper", "the method and the look of the paper (docs/paper.md)", paper},
};

constexpr std::string_view option = "--preset";

}  // namespace

std::span<const Preset> presets() {
    return table;
}

std::vector<std::pair<std::string, std::string>> settings_of_preset(std::string_view name) {
    std::vector<std::pair<std::string, std::string>> settings;
    const auto preset = std::ranges::find(table, name, &Preset::name);
    if (preset == table.end()) return settings;
    for (std::size_t i = 0; i + 1 < preset->arguments.size(); i += 2)
        settings.emplace_back(preset->arguments[i].substr(2), preset->arguments[i + 1]);
    return settings;
}

std::string find_preset(std::span<const std::string> arguments) {
    std::string name;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--") break;
        if (argument == option && i + 1 < arguments.size()) name = arguments[i + 1];
        if (argument.starts_with(option) && argument.substr(option.size()).starts_with('='))
            name = argument.substr(option.size() + 1);
    }
    return name;
}

std::vector<std::string> with_preset(std::span<const std::string> arguments,
                                     const std::function<bool(const std::string& name)>& has) {
    std::vector<std::string> all;
    for (const auto& [name, value] : settings_of_preset(find_preset(arguments))) {
        if (has(name)) all.push_back(fmt::format("--{}={}", name, value));
    }
    all.insert(all.end(), arguments.begin(), arguments.end());
    return all;
}

}  // namespace vvr::options
