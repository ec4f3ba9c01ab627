#pragma once

#include "core/base/plane.h"

namespace vvr::kernels {

/// A row of two frames, of which the second is warped back by the flow. All rows may be read and written one vector
/// beyond their end.
struct WarpRow {
    const Plane<float>& next;  ///< the second frame
    int x;                     ///< column of the row's first point in `next`
    int y;                     ///< row in `next`
    const float* here;         ///< the first frame
    const float *u, *v;        ///< current flow, pixels
    float* mean;               ///< out: mean of the first and the warped second frame
    float* change;             ///< out: difference from the first to the warped second frame
    float* known;              ///< out: 1 where the flow leads into the picture, else 0
    int width;
};
void warp_row(const WarpRow& row);

/// Converts derivatives and difference of a warped row to g and g_t, such that g·w + g_t = 0 has the whole flow w as
/// solution, not only its increment to (u, v). All three are 0 where nothing is known.
/// \param gx, gy in and out: derivatives; aligned, as `gt`
/// \param gt out
void whole_change(const float* u, const float* v, const float* change, const float* known, float* gx, float* gy,
                  float* gt, int width);

}  // namespace vvr::kernels
