#include "cli/options/presets.h"

#include <algorithm>
#include <array>

namespace vvr::options {

namespace {

constexpr PresetSetting day[] = {{"time", "busy"},
                                 {"brick", "01:00:00"},
                                 {"show",
                                  "volume,portraits,map,strip,numbers,directions,outline,ribs,frames,ends,"
                                  "ruler,legend,title,explanation,bricks"}};

// The paper's method and figures; default values where the paper gives none.
constexpr PresetSetting paper[] = {
    {"illumination", "none"},     // colour and light unchanged
    {"shadows", "keep"},          //
    {"stabilize", "off"},         //
    {"flow", "horn-schunck"},     // §4.1: 60 steps with λ = 100, which is α²; the derivatives of [BFB94]
    {"solver", "jacobi"},         //
    {"iterations", "60"},         //
    {"alpha", "10"},              //
    {"derivatives", "barron"},    //
    {"seed-area", "object"},      // §4.2: by the flow and the difference object, the fastest first
    {"seed-order", "magnitude"},  //
    {"layout", "horseshoe"},      // §5.1
    {"time-velocity", "0"},       // §5.2
    {"theme", "light"},           // the figures: dark objects on white, arrows from yellow to red, no text
    {"color", "transfer"},        //
    {"transfer", "grey"},         //
    {"shading", "none"},          //
    {"show", "volume,arrows"},
    {"background", "#ffffff"}};

constexpr std::array table{
    Preset{"day", "a recording of many hours: more room for motion, one brick per hour", day, true},
    Preset{"paper", "the method and the look of the paper (docs/paper.md)", paper},
};

}  // namespace

std::span<const Preset> presets() {
    return table;
}

std::span<const PresetSetting> settings_of_preset(std::string_view name) {
    const auto preset = std::ranges::find(table, name, &Preset::name);
    return preset == table.end() ? std::span<const PresetSetting>() : preset->settings;
}

}  // namespace vvr::options
