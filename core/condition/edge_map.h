#pragma once

#include <cstdint>

#include "core/base/plane.h"

namespace vvr::condition {

/// Where a picture has edges, and which: its gradients at about 64 × 48 pixels. They hardly change with the light, so
/// they tell whether two pictures show the same view.
struct EdgeMap {
    Plane<float> across;  ///< grey levels per pixel
    Plane<float> down;
};

EdgeMap edge_map(const Plane<std::uint8_t>& grey);

/// How far a picture shows a view.
struct Agreement {
    int blocks = 0;       ///< of the view that have edges
    double share = 0;     ///< of these blocks in which the picture has similar edges
    double exact = 0;     ///< of these blocks in which it has the same ones
    double contrast = 0;  ///< ratio of the picture's edges to the view's, in these blocks
};

/// Compares two maps block by block (8 × 8 gradients), by normalised cross-correlation. People cover some blocks;
/// another view differs in nearly all. \param x, y shift of the picture, in pixels of the maps
Agreement agreement(const EdgeMap& picture, const EdgeMap& view, int x = 0, int y = 0);

/// Whether a picture shows the view. It does where too few blocks have edges to tell.
bool shows(const Agreement& view);

/// Whether a picture shows the view if it is shifted by up to two pixels of the maps: the camera shakes.
bool shows_shifted(const EdgeMap& picture, const EdgeMap& view);

}  // namespace vvr::condition
