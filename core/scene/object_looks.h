#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "core/scene/theme.h"

namespace vvr::scene {

/// How an object is while a voxel shows it.
enum class ObjectState {
    moving,
    still,   ///< it stands or lies, and is in a light stretch of its stripes
    marked,  ///< in a dark one
};

/// The look, as in Identity, of an object.
/// \param colour as `colours_of` gives it
std::uint8_t palette_index(int colour, ObjectState posture);

/// All looks, that of what is nobody's first: colour, and a factor on the extinction.
std::vector<glm::vec4> object_palette(const Theme& theme);

}  // namespace vvr::scene
