#include "gl/render_options.h"

#include <algorithm>
#include <array>

namespace vvr::gl {

namespace {

constexpr std::array colours{
    VolumeColourRow{VolumeColour::transfer, "optical_transfer.glsl", false},
    VolumeColourRow{VolumeColour::own, "optical_own.glsl", false},
    VolumeColourRow{VolumeColour::object, "optical_object.glsl", true},
    VolumeColourRow{VolumeColour::time, "optical_time.glsl", true},
};

constexpr std::array shadings{
    VolumeShadingRow{VolumeShading::none, "none", "as mist, darkest where it is densest", "shading_none.glsl"},
    VolumeShadingRow{VolumeShading::relief, "relief", "as solids with light and dark edges; takes about twice the time",
                     "shading_relief.glsl"},
};

}  // namespace

std::span<const VolumeColourRow> volume_colours() {
    return colours;
}

const VolumeColourRow& row_of(VolumeColour colour) {
    return *std::ranges::find(colours, colour, &VolumeColourRow::colour);
}

std::span<const VolumeShadingRow> volume_shadings() {
    return shadings;
}

}  // namespace vvr::gl
