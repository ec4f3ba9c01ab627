#pragma once

#include "core/glance/objects.h"
#include "core/glance/trails.h"
#include "core/scene/glyph.h"

namespace vvr::glance {

/// Arrows along the paths of the objects, at equal distances in time: which way each of them went. None where it stood.
/// \param length of an arrow, P-space units
std::vector<scene::Glyph> direction_arrows(const Objects& objects, const bricks::Volume& volume,
                                           const space::Layout& layout, double length);

}  // namespace vvr::glance
