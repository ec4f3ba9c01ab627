#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/setting.h"

namespace vvr {

namespace setting {
inline constexpr Setting preset{"preset", "NAME", "a set of options for a purpose; options given beside it win"};
}

/// One row of the table of presets: options for a purpose.
struct Preset {
    std::string_view name;
    std::string_view help;
    std::span<const std::string_view> arguments;
    bool needs_whole_clip = false;  ///< so a live stream can't have it
};

std::span<const Preset> presets();

/// Puts the options of the preset that `--preset` names before all others, so that those win. The same arguments where
/// there is none, or none of that name.
std::vector<std::string> with_preset(std::span<const std::string> arguments);

}  // namespace vvr
