#include "cli/options/presets.h"

#include <algorithm>
#include <array>

namespace vvr {

namespace {

constexpr std::array<std::string_view, 6> day{"--time",
                                              "busy",
                                              "--brick",
                                              "01:00:00",
                                              "--show",
                                              "volume,portraits,map,strip,numbers,directions,outline,ribs,frames,ends,"
                                              "floor,ruler,legend,title,explanation,bricks"};

constexpr std::array table{
    Preset{"day", "a recording of many hours: room for what moves, cut by the hour", day},
};

constexpr std::string_view option = "--preset";

}  // namespace

std::span<const Preset> presets() {
    return table;
}

std::vector<std::string> with_preset(std::span<const std::string> arguments) {
    std::vector<std::string> all(arguments.begin(), arguments.end());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        std::string name;
        if (argument == option && i + 1 < arguments.size()) name = arguments[i + 1];
        if (argument.starts_with(option) && argument.substr(option.size()).starts_with('='))
            name = argument.substr(option.size() + 1);
        const auto preset = std::ranges::find(table, name, &Preset::name);
        if (preset != table.end()) all.insert(all.begin(), preset->arguments.begin(), preset->arguments.end());
    }
    return all;
}

}  // namespace vvr
