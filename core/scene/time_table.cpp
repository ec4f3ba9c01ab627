#include "core/scene/time_table.h"

#include <algorithm>
#include <cmath>

namespace vvr::scene {

namespace {

constexpr std::int64_t moments_of_unequal_layer = 64;

}  // namespace

TimeTable::TimeTable(const bricks::Volume& volume)
    : step_(volume.is_nonuniform() ? moments_of_unequal_layer : volume.step()), nonuniform_(volume.is_nonuniform()) {
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        const bricks::Layer& layer = volume.layer(i);
        layers_.push_back({layer.first_frame, layer.last_frame, layer.frames, layer.pts, layer.last_pts});
    }
}

Moment TimeTable::at(double frame) const {
    if (empty()) return {};
    const std::int64_t of_last = nonuniform_ ? step_ : layers_.back().frames;
    const std::int64_t last = step_ * (static_cast<std::int64_t>(layers_.size()) - 1) + of_last - 1;
    const std::int64_t number = std::clamp<std::int64_t>(std::llround(frame), 0, last);
    const Entry& layer = layers_[static_cast<std::size_t>(number / step_)];
    const std::int64_t within = number % step_;
    const std::int64_t moments = nonuniform_ ? step_ : layer.frames;
    const double share = layer.frames > 1 ? static_cast<double>(within) / static_cast<double>(moments - 1) : 0;
    const double frame_there =
        std::lerp(static_cast<double>(layer.first_frame), static_cast<double>(layer.last_frame), share);
    return {std::llround(frame_there), std::lerp(layer.begin, layer.end, share)};
}

}  // namespace vvr::scene
