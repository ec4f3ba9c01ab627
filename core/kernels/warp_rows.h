#pragma once

#include "core/base/plane.h"

namespace vvr::kernels {

/// A row of two frames of which the second is moved back by the flow. All rows may be read and written a vector beyond
/// their end.
struct WarpRow {
    const Plane<float>& next;  ///< the second frame
    int x;                     ///< of the row's first point in `next`
    int y;                     ///< of the row
    const float* here;         ///< the first frame
    const float *u, *v;        ///< flow so far
    float* mean;               ///< out: of the first frame and the moved second one
    float* change;             ///< out: from the first frame to the moved second one
    float* known;              ///< out: 1 where the flow leads to a place in the picture, else 0
    int width;
};
void warp_row(const WarpRow& row);

/// Makes derivatives and the change of a warped row into g and g_t such that g·w + g_t = 0 asks for the whole flow w,
/// not only for what is missing from (u, v). All three are 0 where nothing is known.
/// \param gx, gy derivatives; aligned, as `gt`
/// \param gt out
void whole_change(const float* u, const float* v, const float* change, const float* known, float* gx, float* gy,
                  float* gt, int width);

}  // namespace vvr::kernels
