#pragma once

#include <cstdint>

#include "core/base/plane.h"

namespace vvr::fields {

/// How what a filter found becomes a scalar field.
struct CleanOptions {
    int threshold = 0;  ///< values below it become 0
    int gain = 1;       ///< then all are multiplied by it, 255 at most
    int min_area = 0;   ///< pixels; then blobs of fewer become 0
};

/// \param region where it is 0, so becomes the plane; empty for everywhere
void clean(Plane<std::uint8_t>& plane, const CleanOptions& options, const Plane<std::uint8_t>& region);

}  // namespace vvr::fields
