#pragma once

#include <array>
#include <span>
#include <string_view>

#include <glm/glm.hpp>

namespace vvr::scene {

/// The colours of all that isn't the video's.
struct Theme {
    std::string_view name;
    std::string_view help;
    glm::vec3 background;
    glm::vec3 ink;              ///< text that is to be read first
    glm::vec3 pale_ink;         ///< other text
    glm::vec3 lines;            ///< the volume's outline, the ruler's marks
    glm::vec4 shadow;           ///< on the floor
    std::string_view transfer;  ///< the transfer function that shows well on it
    glm::vec3 slow;             ///< arrows and tracelines
    glm::vec3 fast;
    std::array<glm::vec3, 8> objects;  ///< sRGB; all eyes tell them apart, and their greys differ too
    glm::vec3 unowned;                  ///< what belongs to no object
};

/// The themes; the first is the default.
std::span<const Theme> themes();

}  // namespace vvr::scene
