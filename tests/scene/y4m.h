#pragma once

#include <ostream>

#include "tests/scene/scene.h"

namespace vvr::generator {

/// Writes a scene as YUV4MPEG2, 4:2:0, in television's colours and range: every player and encoder reads it.
///
/// \throws std::runtime_error when `out` can't be written
void write_y4m(const Scene& scene, std::ostream& out);

}  // namespace vvr::generator
