#include "core/bricks/layer.h"

#include <span>

namespace vvr::bricks {

namespace {

/// Pixel by pixel, where either has something.
SparsePlane merged_planes(fields::Values values, const SparsePlane& before, const SparsePlane& after) {
    SparsePlane result(before.size());
    const auto visit = [&](const SparsePlane& plane) {
        plane.for_each_run([&](int column, int row, std::span<const std::uint8_t> run) {
            for (std::size_t i = 0; i < run.size(); ++i, ++column) {
                result.set(column, row, fields::joined(values, before.at(column, row), after.at(column, row)));
            }
        });
    };
    visit(before);
    visit(after);
    return result;
}

}  // namespace

void join(Layer& layer, const Layer& next, fields::Values values) {
    if (!next.colour.empty() || !next.owner.empty()) {
        next.scalar.for_each_run([&](int column, int row, std::span<const std::uint8_t> run) {
            for (const std::uint8_t value : run) {
                if (value > layer.scalar.at(column, row)) {
                    if (!next.colour.empty()) layer.colour.at(column, row) = next.colour.at(column, row);
                    if (!next.owner.empty()) layer.owner.set(column, row, next.owner.at(column, row));
                }
                ++column;
            }
        });
    }
    if (values == fields::Values::strength) {
        layer.scalar.keep_maximum(next.scalar);
    } else {
        layer.scalar = merged_planes(values, layer.scalar, next.scalar);
    }
    layer.frames += next.frames;
    layer.missing += next.missing;
    layer.moving += next.moving;
    layer.last_frame = next.last_frame;
    layer.last_pts = next.last_pts;
}

}  // namespace vvr::bricks
