#pragma once

#include <span>
#include <string_view>
#include <utility>

#include "core/base/setting.h"

namespace vvr::setting {
inline constexpr Setting preset{"preset", "NAME", "a set of options for a purpose; other options override it"};
}

namespace vvr::options {

/// An option that a preset sets, and its value.
using PresetSetting = std::pair<std::string_view, std::string_view>;

/// A preset: options for a purpose.
struct Preset {
    std::string_view name;
    std::string_view help;
    std::span<const PresetSetting> settings;
    bool needs_whole_clip = false;  ///< not possible for live streams
};

std::span<const Preset> presets();

/// The options that a preset sets; none if there is no such preset.
std::span<const PresetSetting> settings_of_preset(std::string_view name);

}  // namespace vvr::options
