#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "core/scene/theme.h"

namespace vvr::scene {

/// How an object is while a voxel shows it.
enum class Posture {
    moving,
    still,   ///< it stands or lies, and is in a light stretch of its stripes
    marked,  ///< in a dark one
};

/// The look, as in Identity, of an object.
/// \param colour as `colours_of` gives it
std::uint8_t look_of(int colour, Posture posture);

/// All looks, that of what is nobody's first: colour, and a factor on the extinction.
std::vector<glm::vec4> looks_of(const Theme& theme);

}  // namespace vvr::scene
