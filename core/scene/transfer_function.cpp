#include "core/scene/transfer_function.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.h"

namespace vvr::scene {

TransferFunction::TransferFunction(std::vector<TransferPoint> points) : points_(std::move(points)) {
    if (points_.empty()) throw Error(ErrorKind::usage, "a transfer function needs at least one point");
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const TransferPoint& point = points_[i];
        if (!(point.extinction >= 0) || !std::isfinite(point.extinction) || !std::isfinite(point.value)) {
            throw Error(ErrorKind::usage, fmt::format("point {} of the transfer function has value {} and extinction "
                                                      "{}; extinction is 0 or more, both are finite",
                                                      i + 1, point.value, point.extinction));
        }
        if (i > 0 && point.value < points_[i - 1].value) {
            throw Error(ErrorKind::usage, fmt::format("the values of a transfer function ascend, but {} follows {}",
                                                      point.value, points_[i - 1].value));
        }
    }
    // A value counts when the function is above zero there or on the way to the next one.
    for (int i = 0; i < 256; ++i) {
        const bool here = at(i).w > 0;
        visible_below_[static_cast<std::size_t>(i) + 1] = visible_below_[static_cast<std::size_t>(i)] + (here ? 1 : 0);
    }
}

glm::dvec4 TransferFunction::at(double value) const {
    const auto after = std::ranges::upper_bound(points_, value, {}, &TransferPoint::value);
    if (after == points_.begin()) return {points_.front().colour, points_.front().extinction};
    if (after == points_.end()) return {points_.back().colour, points_.back().extinction};
    const TransferPoint& low = *(after - 1);
    const double share = (value - low.value) / (after->value - low.value);
    return {glm::mix(low.colour, after->colour, share), std::lerp(low.extinction, after->extinction, share)};
}

bool TransferFunction::visible(const bricks::ValueRange& range) const {
    if (range.high < range.low) return false;
    return visible_below_[static_cast<std::size_t>(range.high) + 1] > visible_below_[range.low];
}

TransferFunction TransferFunction::scaled(double opacity) const {
    std::vector<TransferPoint> points = points_;
    for (TransferPoint& point : points) point.extinction *= opacity;
    return TransferFunction(std::move(points));
}

TransferFunction default_transfer_function() {
    return TransferFunction({
        {12, {0.20, 0.38, 0.62}, 0},
        {48, {0.22, 0.45, 0.70}, 9},
        {128, {0.16, 0.30, 0.58}, 32},
        {255, {0.08, 0.14, 0.36}, 70},
    });
}

}  // namespace vvr::scene
