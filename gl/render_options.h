#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/space/camera.h"

namespace vvr::gl {

/// Source of the volume's colour. Extinction always comes from the transfer function.
enum class VolumeColour {
    transfer,  ///< transfer function of the scalar
    own,       ///< each voxel has its own
    object,    ///< each voxel has an identity, an index into the palette
    time,      ///< each voxel has the palette's colour for its time
};

struct VolumeColourRow {
    VolumeColour colour;
    std::string_view shader;  ///< file in glsl/ that defines optical_at(place), scalar_of(voxel) and number_at(place)
    bool uses_palette;        ///< the shader reads those of VolumeSlicer::set_palette
};

/// The first row is the default.
inline constexpr std::array volume_colours{
    VolumeColourRow{VolumeColour::transfer, "optical_transfer.glsl", false},
    VolumeColourRow{VolumeColour::own, "optical_own.glsl", false},
    VolumeColourRow{VolumeColour::object, "optical_object.glsl", true},
    VolumeColourRow{VolumeColour::time, "optical_time.glsl", true},
};

constexpr const VolumeColourRow& row_of(VolumeColour colour) {
    return *std::ranges::find(volume_colours, colour, &VolumeColourRow::colour);
}

/// Shading of the volume.
enum class VolumeShading { none, relief };

struct VolumeShadingRow {
    VolumeShading shading;
    std::string_view name;
    std::string_view help;
    std::string_view shader;  ///< file in glsl/ that defines shaded(colour)
};

/// The first row is the default.
inline constexpr std::array volume_shadings{
    VolumeShadingRow{VolumeShading::none, "none", "like mist, darkest where it is densest", "shading_none.glsl"},
    VolumeShadingRow{VolumeShading::relief, "relief",
                     "like solids with light and dark edges; takes about twice the time", "shading_relief.glsl"},
};

/// Style of the arrows.
struct GlyphStyle {
    float thickness = 0.05F;            ///< P-space units per unit of the reference glyph's radius
    glm::vec2 speed_range{0.3F, 6.0F};  ///< pixels per frame at the ends of the colour scale
    glm::vec3 slow_colour{0.98F, 0.72F, 0.20F};
    glm::vec3 fast_colour{0.84F, 0.16F, 0.10F};
};

/// Style of the tracelines. Their colours are those of the arrows.
struct TraceStyle {
    float width = 0.0045F;        ///< P-space units
    float min_width = 1.6F;       ///< pixels
    float stripe_length = 0.02F;  ///< P-space units between two dark stripes
    float shade = 0.3F;           ///< brightness of dark stripes, 0..1
};

/// How to draw a picture.
struct RenderOptions {
    Size size{1280, 960};
    space::View view;
    std::optional<space::Camera> camera;  ///< overrides the camera that fits the volume from `view`
    int slices = 0;                       ///< 0 = one per two voxels
    int samples = 4;                      ///< per pixel, for antialiasing; 1 takes about half the time
    std::int64_t tile_samples = 1 << 20;  ///< samples per tile, 24 bytes each: bounds memory for large pictures
    glm::vec4 background{1, 1, 1, 1};     ///< premultiplied RGBA
    VolumeColour colour = VolumeColour::transfer;
    VolumeShading shading = VolumeShading::none;
    GlyphStyle glyphs;
    TraceStyle traces;
};

}  // namespace vvr::gl
