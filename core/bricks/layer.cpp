#include "core/bricks/layer.h"

#include <span>

namespace vvr {

void join(Layer& layer, const Layer& next) {
    if (!next.colour.empty() || !next.owner.empty()) {
        next.scalar.each_run([&](int column, int row, std::span<const std::uint8_t> values) {
            for (const std::uint8_t value : values) {
                if (value > layer.scalar.at(column, row)) {
                    if (!next.colour.empty()) layer.colour.at(column, row) = next.colour.at(column, row);
                    if (!next.owner.empty()) layer.owner.set(column, row, next.owner.at(column, row));
                }
                ++column;
            }
        });
    }
    layer.scalar.keep_greater(next.scalar);
    layer.frames += next.frames;
    layer.missing += next.missing;
    layer.moving += next.moving;
    layer.last_frame = next.last_frame;
    layer.last_pts = next.last_pts;
}

}  // namespace vvr
