#pragma once

#include <vector>

#include "cli/app/plan.h"
#include "core/image/picture.h"
#include "core/labels/sheet.h"

namespace vvr::app {

/// The legend: the meaning of a picture's colours.
std::vector<labels::LegendEntry> legend_of(const Plan& plan);

inline image::Rgba rgba(const glm::vec3& colour) {
    return {colour.x, colour.y, colour.z, 1};
}

}  // namespace vvr::app
