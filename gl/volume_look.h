#pragma once

#include <span>
#include <string_view>

namespace vvr {

/// Where the volume's colour comes from; extinction is the transfer function's.
enum class VolumeColour { transfer, video, object };

struct VolumeColourRow {
    VolumeColour colour;
    std::string_view name;
    std::string_view help;
    std::string_view shader;  ///< file in glsl/ that defines optical_at(place), scalar_of(voxel) and number_at(place)
};

/// The sources of colour there are; the first is the default.
std::span<const VolumeColourRow> volume_colours();

/// How light falls on the volume.
enum class VolumeShading { none, relief };

struct VolumeShadingRow {
    VolumeShading shading;
    std::string_view name;
    std::string_view help;
    std::string_view shader;  ///< file in glsl/ that defines shaded(colour)
};

/// The ways there are; the first is the default.
std::span<const VolumeShadingRow> volume_shadings();

}  // namespace vvr
