#pragma once

#include <cstdint>
#include <vector>

#include "core/bricks/brick_layers.h"
#include "core/space/layout.h"

namespace vvr::bricks {

/// The least and greatest value that interpolation can give within a cell.
struct ValueRange {
    std::uint8_t low = 255;
    std::uint8_t high = 0;
};

/// The part of a cell, in x_C and y_C, outside of which interpolation gives nothing but 0. Empty where all is 0.
struct CellBox {
    double x_low = 1;
    double x_high = 0;
    double y_low = 1;
    double y_high = 0;
};

/// A brick cut into cells: blocks of C-space small enough that a layout bends them into nearly straight hexahedra.
/// Cells with nothing visible in them are left out when slices are cut.
struct BrickCells {
    std::vector<double> x;  ///< ascending borders in x_C, one more than there are cells; the outer ones lie outside
    std::vector<double> y;
    std::vector<double> t;           ///< in t_B, from 0 to 1 over the brick
    std::vector<ValueRange> ranges;  ///< x fastest, then y, then t
    std::vector<CellBox> boxes;      ///< of the same cells

    int nx() const { return static_cast<int>(x.size()) - 1; }
    int ny() const { return static_cast<int>(y.size()) - 1; }
    int nt() const { return static_cast<int>(t.size()) - 1; }

    const ValueRange& range(int ix, int iy, int it) const { return ranges[at(ix, iy, it)]; }

    /// The part of a cell in which something can be seen.
    /// \param zero_is_empty whether the value 0 is invisible; else it is the whole cell
    CellBox part(int ix, int iy, int it, bool zero_is_empty) const {
        if (zero_is_empty) return boxes[at(ix, iy, it)];
        const auto i = static_cast<std::size_t>(ix);
        const auto j = static_cast<std::size_t>(iy);
        return {x[i], x[i + 1], y[j], y[j + 1]};
    }

    std::size_t at(int ix, int iy, int it) const { return static_cast<std::size_t>((it * ny() + iy) * nx() + ix); }
};

/// The cells of a brick.
/// \param t_span the part of the window's t_C that the brick takes
/// \param margin P-space units around what can be seen that belong to the cells too. A pixel is shaded at its
///        centre, and weighted by how much of it a polygon covers. With half of a pixel's diagonal as the margin,
///        cells cover the whole of each pixel in whose centre something is seen, however the volume
///        is cut.
BrickCells brick_cells(const BrickLayers& layers, double t_span, const space::Layout& layout, double margin = 0);

/// The cells of a brick, and the part of the window's t_C that the brick takes.
struct PlacedCells {
    const BrickCells* cells = nullptr;
    double t_begin = 0;
    double t_end = 1;
};

}  // namespace vvr::bricks
