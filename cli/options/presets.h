#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/setting.h"

namespace vvr::setting {
inline constexpr Setting preset{"preset", "NAME", "a set of options for a purpose; other options override it"};
}

namespace vvr::options {

/// A preset: options for a purpose.
struct Preset {
    std::string_view name;
    std::string_view help;
    std::span<const std::string_view> arguments;
    bool needs_whole_clip = false;  ///< not possible for live streams
};

std::span<const Preset> presets();

/// The options that a preset sets, by name; none if there is no such preset.
std::vector<std::pair<std::string, std::string>> settings_of_preset(std::string_view name);

/// The value of `--preset` in the arguments; empty = not given.
std::string find_preset(std::span<const std::string> arguments);

/// Inserts the preset's options before all other arguments, so that the others win. Returns the arguments unchanged if
/// `--preset` is not given or names no preset.
/// \param has whether the command has an option; the others are skipped
std::vector<std::string> with_preset(std::span<const std::string> arguments,
                                     const std::function<bool(const std::string& name)>& has);

}  // namespace vvr::options
