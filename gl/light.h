#pragma once

#include "core/space/camera.h"

namespace vvr::gl {

/// The direction to the light that all is drawn in: above and behind the viewer's left shoulder.
inline glm::vec3 to_light(const space::Camera& camera) {
    const glm::dvec3 right = glm::cross(glm::dvec3(0, 1, 0), camera.forward);
    return glm::vec3(glm::normalize(glm::dvec3(0, 1.4, 0) - camera.forward - 0.4 * right));
}

}  // namespace vvr::gl
