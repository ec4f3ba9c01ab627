#include "core/fields/motion.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "core/fields/tiles.h"

namespace vvr::fields {
namespace {

constexpr double memory = 0.4;  // seconds over which something has to have moved
constexpr double lasting = 1;   // seconds for which whoever stops for a moment counts as moving
constexpr int moved = 12;       // pixels of a tile's 64 that come or go; the edge of what stands still flickers by less

/// How many pixels of each tile hold something.
std::vector<std::uint8_t> filling(const Plane<std::uint8_t>& scalar) {
    const int columns = (scalar.width() + tile_side - 1) / tile_side;
    const int rows = (scalar.height() + tile_side - 1) / tile_side;
    std::vector<std::uint8_t> counts(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int j = 0; j < scalar.height(); ++j) {
        std::uint8_t* const out = counts.data() + static_cast<std::ptrdiff_t>(j / tile_side) * columns;
        const auto row = scalar.row(j);
        for (std::size_t i = 0; i < row.size(); ++i)
            if (row[i] != 0) ++out[i / tile_side];
    }
    return counts;
}

bool differ(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::abs(a[i] - b[i]) >= moved) return true;
    }
    return false;
}

}  // namespace

bool MotionDetector::operator()(const Field& field) {
    past_.push_back({field.pts, filling(field.scalar)});
    while (past_.size() > 2 && field.pts - past_[1].pts >= memory) past_.pop_front();
    if (differ(past_.front().filling, past_.back().filling)) last_ = field.pts;
    return last_ && field.pts - *last_ <= lasting;
}

}  // namespace vvr::fields
