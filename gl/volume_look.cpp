#include "gl/volume_look.h"

#include <array>

namespace vvr {

namespace {

constexpr std::array colours{
    VolumeColourRow{VolumeColour::transfer, "transfer", "the transfer function's", "optical_transfer.glsl"},
    VolumeColourRow{VolumeColour::video, "video", "the video's own", "optical_video.glsl"},
    VolumeColourRow{VolumeColour::object, "object", "each object its own; what is no object's is grey and faint",
                    "optical_object.glsl"},
};

constexpr std::array shadings{
    VolumeShadingRow{VolumeShading::none, "none", "as mist: where most is, it is darkest", "shading_none.glsl"},
    VolumeShadingRow{VolumeShading::relief, "relief", "as solids with light and dark edges; takes about twice the time",
                     "shading_relief.glsl"},
};

}  // namespace

std::span<const VolumeColourRow> volume_colours() {
    return colours;
}

std::span<const VolumeShadingRow> volume_shadings() {
    return shadings;
}

}  // namespace vvr
