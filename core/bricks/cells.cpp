#include "core/bricks/cells.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vvr {

namespace {

// Voxels. Smaller cells leave out more of what is empty, larger ones make fewer triangles; measured on street scenes.
constexpr int cell_side = 12;

std::vector<double> borders(int cells) {
    std::vector<double> result(static_cast<std::size_t>(cells) + 1);
    for (int i = 0; i <= cells; ++i) {
        result[static_cast<std::size_t>(i)] = static_cast<double>(i) / cells;
    }
    return result;
}

int cells_along(std::int64_t voxels) { return static_cast<int>((voxels + cell_side - 1) / cell_side); }

/// First and last of the `count` texels of one axis that touch cell `i` of `cells`, `apron` texels more on each side.
std::array<std::int64_t, 2> touched(int i, int cells, std::int64_t count, double apron) {
    const double scale = static_cast<double>(count) / cells;
    const auto low = static_cast<std::int64_t>(std::floor(i * scale - 0.5 - apron));
    const auto high = static_cast<std::int64_t>(std::ceil((i + 1) * scale - 0.5 + apron));
    return {std::clamp<std::int64_t>(low, 0, count - 1), std::clamp<std::int64_t>(high, 0, count - 1)};
}

/// The range of every cell of one texel layer, joined into `into`.
void join_layer(std::span<const std::uint8_t> layer, Size size, const std::vector<std::array<std::int64_t, 2>>& columns,
                const std::vector<std::array<std::int64_t, 2>>& rows, std::vector<ValueRange>& into) {
    std::vector<ValueRange> of_row(columns.size());
    for (int j = 0; j < size.height; ++j) {
        const auto row = layer.subspan(static_cast<std::size_t>(j) * static_cast<std::size_t>(size.width),
                                       static_cast<std::size_t>(size.width));
        for (std::size_t c = 0; c < columns.size(); ++c) {
            ValueRange range;
            for (std::int64_t i = columns[c][0]; i <= columns[c][1]; ++i) {
                const std::uint8_t value = row[static_cast<std::size_t>(i)];
                range.low = std::min(range.low, value);
                range.high = std::max(range.high, value);
            }
            of_row[c] = range;
        }
        for (std::size_t r = 0; r < rows.size(); ++r) {
            if (j < rows[r][0] || j > rows[r][1]) continue;
            for (std::size_t c = 0; c < columns.size(); ++c) {
                ValueRange& cell = into[r * columns.size() + c];
                cell.low = std::min(cell.low, of_row[c].low);
                cell.high = std::max(cell.high, of_row[c].high);
            }
        }
    }
}

}  // namespace

BrickCells brick_cells(const BrickTexels& texels, double t_span, const Layout& layout) {
    const int nx = cells_along(texels.size.width);
    const int ny = cells_along(texels.size.height);
    const int nt = std::max(cells_along(texels.brick.count),
                            static_cast<int>(std::ceil(t_span / layout.straight_t() - 1e-9)));

    BrickCells cells;
    cells.x = borders(nx);
    cells.y = borders(ny);
    cells.t = borders(nt);

    // Between two straight cells lies a sliver that bends out of one and into the other: the apron covers it.
    const double bend = layout.sagitta_x(t_span / nt) * texels.size.width;
    std::vector<std::array<std::int64_t, 2>> columns;
    std::vector<std::array<std::int64_t, 2>> rows;
    for (int i = 0; i < nx; ++i) columns.push_back(touched(i, nx, texels.size.width, bend));
    for (int j = 0; j < ny; ++j) rows.push_back(touched(j, ny, texels.size.height, 0));

    const auto plane = static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny);
    std::vector<ValueRange> of_layers(plane * static_cast<std::size_t>(texels.layers()));
    for (std::int64_t layer = 0; layer < texels.layers(); ++layer) {
        std::vector<ValueRange> ranges(plane);
        join_layer(texels.layer(layer), texels.size, columns, rows, ranges);
        std::ranges::copy(ranges, of_layers.begin() + static_cast<std::ptrdiff_t>(plane * static_cast<std::size_t>(layer)));
    }

    cells.ranges.resize(plane * static_cast<std::size_t>(nt));
    for (int t = 0; t < nt; ++t) {
        // Texel layer l stands at (l - 1 + 0.5) / count of the brick: one more layer before the brick than in it.
        const double scale = static_cast<double>(texels.brick.count) / nt;
        const auto low = static_cast<std::int64_t>(std::floor(t * scale + 0.5));
        const auto high = static_cast<std::int64_t>(std::ceil((t + 1) * scale + 0.5));
        for (std::int64_t layer = std::max<std::int64_t>(low, 0); layer <= std::min(high, texels.layers() - 1); ++layer) {
            for (std::size_t c = 0; c < plane; ++c) {
                ValueRange& cell = cells.ranges[plane * static_cast<std::size_t>(t) + c];
                const ValueRange& of_layer = of_layers[plane * static_cast<std::size_t>(layer) + c];
                cell.low = std::min(cell.low, of_layer.low);
                cell.high = std::max(cell.high, of_layer.high);
            }
        }
    }
    return cells;
}

}  // namespace vvr
