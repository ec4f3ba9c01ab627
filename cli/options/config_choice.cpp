#include "cli/options/config_choice.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <system_error>

namespace vvr::options {

namespace {

constexpr std::string_view option = "--config";

/// The last one wins, as with every option.
std::optional<std::string> given_file(std::span<const std::string> arguments) {
    std::optional<std::string> file;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--") break;
        if (argument == option && i + 1 < arguments.size()) file = arguments[i + 1];
        if (argument.starts_with(option) && argument.substr(option.size()).starts_with('=')) {
            file = argument.substr(option.size() + 1);
        }
    }
    return file;
}

std::vector<std::filesystem::path> usual_places() {
    std::vector<std::filesystem::path> places;
    const char* const config_home = std::getenv("XDG_CONFIG_HOME");
    const char* const home = std::getenv("HOME");
    // The XDG Base Directory Specification says to ignore relative paths.
    if (config_home != nullptr && std::filesystem::path(config_home).is_absolute()) {
        places.push_back(std::filesystem::path(config_home) / "vvr/vvr.toml");
    } else if (home != nullptr && std::filesystem::path(home).is_absolute()) {
        places.push_back(std::filesystem::path(home) / ".config/vvr/vvr.toml");
    }
    places.emplace_back("/etc/vvr/vvr.toml");
    return places;
}

}  // namespace

ConfigChoice find_config(std::span<const std::string> arguments) {
    if (const auto file = given_file(arguments)) return {*file, "named by --config", {}, true};
    if (std::ranges::find(arguments, "--no-config") != arguments.end()) return {{}, "because of --no-config", {}};
    if (const char* const named = std::getenv("VVR_CONFIG")) {
        return {named, *named == 0 ? "because VVR_CONFIG is empty" : "named by VVR_CONFIG", {}};
    }
    const std::vector<std::filesystem::path> places = usual_places();
    const auto there = std::ranges::find_if(places, [](const std::filesystem::path& place) {
        std::error_code ignored;
        return std::filesystem::exists(place, ignored);
    });
    return {there == places.end() ? std::filesystem::path() : *there, "found there", places};
}

}  // namespace vvr::options
