#pragma once

#include <span>
#include <string_view>

namespace vvr::gl {

/// Where the volume's colour comes from; extinction is the transfer function's.
enum class VolumeColour {
    transfer,  ///< of the scalar
    own,       ///< each voxel has one of its own
    object,    ///< each voxel has an identity, and that a look
    time,      ///< looks in the order of time
};

struct VolumeColourRow {
    VolumeColour colour;
    std::string_view shader;  ///< file in glsl/ that defines optical_at(place), scalar_of(voxel) and number_at(place)
    bool uses_palette;         ///< the shader reads those of VolumeSlicer::set_looks
};

/// The sources of colour there are; the first is the default.
std::span<const VolumeColourRow> volume_colours();

const VolumeColourRow& row_of(VolumeColour colour);

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

}  // namespace vvr::gl
