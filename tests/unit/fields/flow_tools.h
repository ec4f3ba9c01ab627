#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "core/fields/flow.h"
#include "tests/unit/fields/pictures.h"

namespace vvr::test {

inline fields::Rect whole(Size size) {
    return {0, 0, size};
}

/// Frames as `method` wants them, to be looked at from the middle one.
inline std::vector<const fields::FlowFrame*> about(const std::vector<fields::FlowFrame>& frames, int middle,
                                                   int reach) {
    std::vector<const fields::FlowFrame*> result;
    for (int k = middle - reach; k <= middle + reach; ++k) {
        result.push_back(&frames[static_cast<std::size_t>(std::clamp(k, 0, static_cast<int>(frames.size()) - 1))]);
    }
    return result;
}

/// The flow of frame `middle`.
inline fields::Flow flow_of(std::span<const Plane<std::uint8_t>> frames, int middle,
                            const fields::FlowOptions& options) {
    const auto method = fields::make_flow(options);
    std::vector<fields::FlowFrame> prepared;
    for (const Plane<std::uint8_t>& frame : frames) prepared.push_back(method->prepare(frame));
    return (*method)(about(prepared, middle, method->reach()), whole(frames.front().size()));
}

/// Frames of the texture moving by (u, v).
inline std::vector<Plane<std::uint8_t>> moving_texture(Size size, int count, double u, double v) {
    std::vector<Plane<std::uint8_t>> frames;
    for (int f = 0; f < count; ++f) frames.push_back(texture_frame(size, f, u, v).grey);
    return frames;
}

/// Frames of the rough texture moving by (u, v).
inline std::vector<Plane<std::uint8_t>> moving_rough_texture(Size size, int count, double u, double v) {
    std::vector<Plane<std::uint8_t>> frames;
    for (int f = 0; f < count; ++f) {
        frames.push_back(grey_plane(size, [&](int i, int j) { return rough_texture(i - u * f, j - v * f); }));
    }
    return frames;
}

/// What is wrong with a flow, `border` pixels away from its edges.
struct FlowError {
    double angle = 0;      ///< degrees between (u, v, 1) and the truth, mean
    double deviation = 0;  ///< its standard deviation
    double end_point = 0;  ///< pixels, mean
};

inline FlowError error_of(const fields::Flow& flow, double u, double v, int border) {
    double sum = 0, squares = 0, distance = 0;
    int count = 0;
    for (int j = border; j < flow.u.height() - border; ++j) {
        for (int i = border; i < flow.u.width() - border; ++i, ++count) {
            const double x = flow.u.at(i, j);
            const double y = flow.v.at(i, j);
            const double cosine = (x * u + y * v + 1) / std::sqrt((x * x + y * y + 1) * (u * u + v * v + 1));
            const double angle = std::acos(std::min(cosine, 1.0)) * 180 / std::numbers::pi;
            sum += angle;
            squares += angle * angle;
            distance += std::hypot(x - u, y - v);
        }
    }
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean)), distance / count};
}

}  // namespace vvr::test
