#include "core/volume/cells.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vvr::volume {

namespace {

// Voxels, measured on street scenes. Smaller cells skip more empty space, larger cells make fewer triangles. A cell's
// box trims empty space in x and y, but not in time, so cells are shorter in time.
constexpr int cell_side = 32;
constexpr int cell_layers = 16;

std::vector<double> borders(int cells) {
    std::vector<double> result(static_cast<std::size_t>(cells) + 1);
    for (int i = 0; i <= cells; ++i) {
        result[static_cast<std::size_t>(i)] = static_cast<double>(i) / cells;
    }
    return result;
}

int cells_along(std::int64_t voxels, int side) {
    return static_cast<int>((voxels + side - 1) / side);
}

/// The first and last texel of one axis that touch a cell.
struct Reach {
    std::int64_t first;
    std::int64_t last;
};

/// The texels, of `count`, that cell `i` of `cells` touches, plus `apron` texels on each side.
Reach reach(int i, int cells, std::int64_t count, double apron) {
    const double scale = static_cast<double>(count) / cells;
    const auto low = static_cast<std::int64_t>(std::floor(i * scale - 0.5 - apron));
    const auto high = static_cast<std::int64_t>(std::ceil((i + 1) * scale - 0.5 + apron));
    return {std::clamp<std::int64_t>(low, 0, count - 1), std::clamp<std::int64_t>(high, 0, count - 1)};
}

/// The texel layers that cell `i` of `cells` touches in time, plus `apron` layers on each side. Texel layer l is at
/// (l - 1 + 0.5) / count of the brick, because there is one extra layer before the brick.
Reach layers_reach(int i, int cells, const BrickLayers& layers, double apron) {
    const double scale = static_cast<double>(layers.brick().count) / cells;
    const auto low = static_cast<std::int64_t>(std::floor(i * scale + 0.5 - apron));
    const auto high = static_cast<std::int64_t>(std::ceil((i + 1) * scale + 0.5 + apron));
    return {std::max<std::int64_t>(low, 0), std::min(high, layers.count() - 1)};
}

Reach intersection(Reach a, Reach b) {
    return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

/// The minimum and maximum over some layers of each texel in a strip of rows. Processes whole rows, which the compiler
/// vectorises; the speed is limited by memory bandwidth. Texels outside the layers' box are 0.
class Strip {
  public:
    explicit Strip(const BrickLayers& layers)
        : layers_(&layers),
          box_columns_{layers.box().left, layers.box().right - 1},
          box_rows_{layers.box().top, layers.box().bottom - 1},
          width_(static_cast<std::size_t>(layers.box().width())) {}

    void fill_texels(Reach layers) {
        texels_.resize(static_cast<std::size_t>(layers.last - layers.first + 1) * layers_->area());
        layers_->fill_texels(layers.first, texels_);
    }

    /// Computes the minimum and maximum of these rows over the filled layers.
    void merge_layers(Reach rows) {
        rows_ = intersection(rows, box_rows_);
        whole_rows_ = rows_.first == rows.first && rows_.last == rows.last;
        if (rows_.first > rows_.last) return;
        const auto first = static_cast<std::size_t>(rows_.first - box_rows_.first) * width_;
        const std::size_t count = static_cast<std::size_t>(rows_.last - rows_.first + 1) * width_;
        low_.assign(count, 255);
        high_.assign(count, 0);
        for (std::size_t layer = 0; layer < texels_.size(); layer += layers_->area()) {
            const auto strip = std::span(texels_).subspan(layer + first, count);
            for (std::size_t i = 0; i < count; ++i) {
                low_[i] = std::min(low_[i], strip[i]);
                high_[i] = std::max(high_[i], strip[i]);
            }
        }
    }

    ValueRange range(Reach columns) const {
        const Reach held = intersection(columns, box_columns_);
        ValueRange range;
        if (!whole_rows_ || held.first != columns.first || held.last != columns.last) range = {0, 0};
        each(held, [&](std::int64_t, std::int64_t, std::size_t at) {
            range.low = std::min(range.low, low_[at]);
            range.high = std::max(range.high, high_[at]);
        });
        return range;
    }

    /// The columns and rows of non-zero texels. If there are none, first is greater than last.
    std::array<Reach, 2> occupied(Reach columns) const {
        std::array<Reach, 2> found = {Reach{columns.last + 1, columns.first - 1},
                                      Reach{rows_.last + 1, rows_.first - 1}};
        each(intersection(columns, box_columns_), [&](std::int64_t column, std::int64_t row, std::size_t at) {
            if (high_[at] == 0) return;
            found[0] = {std::min(found[0].first, column), std::max(found[0].last, column)};
            found[1] = {std::min(found[1].first, row), std::max(found[1].last, row)};
        });
        return found;
    }

  private:
    template <typename Visit>
    void each(Reach columns, const Visit& visit) const {
        for (std::int64_t row = rows_.first; row <= rows_.last; ++row) {
            const std::size_t begin = static_cast<std::size_t>(row - rows_.first) * width_;
            for (std::int64_t column = columns.first; column <= columns.last; ++column) {
                visit(column, row, begin + static_cast<std::size_t>(column - box_columns_.first));
            }
        }
    }

    const BrickLayers* layers_;
    std::vector<std::uint8_t> texels_;
    Reach box_columns_;
    Reach box_rows_;
    std::size_t width_;
    Reach rows_{0, -1};
    bool whole_rows_ = true;  ///< the box holds all rows of the strip
    std::vector<std::uint8_t> low_;
    std::vector<std::uint8_t> high_;
};

/// The interval that texels of `reach` influence by interpolation, where `count` texels span 0..1, widened by `more`.
std::array<double, 2> influenced_interval(Reach reach, std::int64_t count, double more) {
    const auto n = static_cast<double>(count);
    return {(static_cast<double>(reach.first) - 0.5) / n - more, (static_cast<double>(reach.last) + 1.5) / n + more};
}

}  // namespace

BrickCells brick_cells(const BrickLayers& layers, double t_span, const space::Layout& layout, double margin) {
    const Size size = layers.size();
    // In x_C, y_C and t_C, where the arc is shortest.
    const space::Basis basis = layout.basis({0, 0.5, 0.5});
    const glm::dvec3 around = margin / glm::dvec3(glm::length(basis.x), glm::length(basis.y), glm::length(basis.t));
    const int nx = cells_along(size.width, cell_side);
    const int ny = cells_along(size.height, cell_side);
    const int nt = std::max(cells_along(layers.brick().count, cell_layers),
                            static_cast<int>(std::ceil(t_span / layout.straight_t() - 1e-9)));

    BrickCells cells;
    cells.x = borders(nx);
    cells.y = borders(ny);
    cells.t = borders(nt);

    // The curved border of two cells deviates from their straight sides. The apron covers that sliver.
    const double bend = layout.sagitta_x(t_span / nt);
    // Extends the outer cells, because flat outer faces would clip the curved volume. The shader rejects what is
    // outside.
    cells.x.front() -= around.x;
    cells.x.back() += 2 * bend + around.x;
    std::vector<Reach> columns;
    for (int i = 0; i < nx; ++i) columns.push_back(reach(i, nx, size.width, (bend + around.x) * size.width));

    const double more_layers = around.z / t_span * static_cast<double>(layers.brick().count);
    Strip strip(layers);
    for (int t = 0; t < nt; ++t) {
        strip.fill_texels(layers_reach(t, nt, layers, more_layers));
        for (int j = 0; j < ny; ++j) {
            strip.merge_layers(reach(j, ny, size.height, around.y * size.height));
            const auto row = static_cast<std::size_t>(j);
            for (std::size_t i = 0; i < columns.size(); ++i) {
                cells.ranges.push_back(strip.range(columns[i]));
                CellBox& box = cells.boxes.emplace_back();
                if (cells.ranges.back().high == 0) continue;
                const auto [lit_columns, lit_rows] = strip.occupied(columns[i]);
                const auto [x_low, x_high] = influenced_interval(lit_columns, size.width, bend + around.x);
                const auto [y_low, y_high] = influenced_interval(lit_rows, size.height, around.y);
                box = {std::max(x_low, cells.x[i]), std::min(x_high, cells.x[i + 1]), std::max(y_low, cells.y[row]),
                       std::min(y_high, cells.y[row + 1])};
            }
        }
    }
    return cells;
}

}  // namespace vvr::volume
