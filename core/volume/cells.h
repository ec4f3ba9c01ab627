#pragma once

#include <cstdint>
#include <vector>

#include "core/space/layout.h"
#include "core/volume/brick.h"

namespace vvr::volume {

/// The minimum and maximum of the interpolated values within a cell.
struct ValueRange {
    std::uint8_t low = 255;
    std::uint8_t high = 0;
};

/// The part of a cell, in x_C and y_C, outside which all interpolated values are 0. Empty if all values are 0.
struct CellBox {
    double x_low = 1;
    double x_high = 0;
    double y_low = 1;
    double y_high = 0;
};

/// A brick divided into cells: blocks of C-space small enough that a layout maps them to nearly straight hexahedra.
/// Slices skip the cells without visible voxels.
struct BrickCells {
    std::vector<double> x;           ///< ascending cell borders in x_C; the outer ones may be outside 0..1
    std::vector<double> y;           ///< the same in y_C
    std::vector<double> t;           ///< ascending cell borders in t_B, 0..1 over the brick
    std::vector<ValueRange> ranges;  ///< x fastest, then y, then t
    std::vector<CellBox> boxes;      ///< in the same order

    int nx() const { return static_cast<int>(x.size()) - 1; }
    int ny() const { return static_cast<int>(y.size()) - 1; }
    int nt() const { return static_cast<int>(t.size()) - 1; }

    const ValueRange& range(int ix, int iy, int it) const { return ranges[at(ix, iy, it)]; }

    /// The part of a cell that may be visible.
    /// \param zero_is_empty whether the value 0 is invisible; if not, the part is the whole cell
    CellBox part(int ix, int iy, int it, bool zero_is_empty) const {
        if (zero_is_empty) return boxes[at(ix, iy, it)];
        const auto i = static_cast<std::size_t>(ix);
        const auto j = static_cast<std::size_t>(iy);
        return {x[i], x[i + 1], y[j], y[j + 1]};
    }

    std::size_t at(int ix, int iy, int it) const { return static_cast<std::size_t>((it * ny() + iy) * nx() + ix); }
};

/// Divides a brick into cells.
/// \param t_span length of the brick in t_C
/// \param margin P-space units added around the visible voxels. A pixel is shaded at its centre and weighted by the
///        coverage of the polygon. With a margin of half a pixel's diagonal, cells cover each pixel whose centre is
///        visible completely, however the volume is divided.
BrickCells brick_cells(const BrickLayers& layers, double t_span, const space::Layout& layout, double margin = 0);

/// The cells of a brick and the brick's interval of t_C.
struct PlacedCells {
    const BrickCells* cells = nullptr;
    double t_begin = 0;
    double t_end = 1;
};

}  // namespace vvr::volume
