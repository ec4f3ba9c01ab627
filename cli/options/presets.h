#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/setting.h"

namespace vvr::setting {
inline constexpr Setting preset{"preset", "NAME", "a set of options for a purpose; options given beside it win"};
}

namespace vvr::options {

/// One row of the table of presets: options for a purpose.
struct Preset {
    std::string_view name;
    std::string_view help;
    std::span<const std::string_view> arguments;
    bool needs_whole_clip = false;  ///< so a live stream can't have it
};

std::span<const Preset> presets();

/// What a preset sets, by the options' names; nothing where there is none of that name.
std::vector<std::pair<std::string, std::string>> settings_of_preset(std::string_view name);

/// The preset that `--preset` names among the arguments; empty where there is none.
std::string find_preset(std::span<const std::string> arguments);

/// Puts the options of the preset that `--preset` names before all others, so that those win. The same arguments where
/// there is none, or none of that name.
/// \param has whether the command has an option; what it doesn't have is left out
std::vector<std::string> with_preset(std::span<const std::string> arguments,
                                     const std::function<bool(const std::string& name)>& has);

}  // namespace vvr::options
