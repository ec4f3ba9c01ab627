#pragma once

#include "core/glance/objects.h"
#include "core/glance/trails.h"
#include "core/scene/glyph.h"

namespace vvr {

/// Arrows along the paths of the objects, at equal distances in time: which way each of them went. None where it stood.
/// \param length of an arrow, P-space units
std::vector<Glyph> direction_arrows(const Objects& objects, const Volume& volume, const Layout& layout, double length);

}  // namespace vvr
