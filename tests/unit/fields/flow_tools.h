#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "core/fields/flow.h"
#include "tests/unit/fields/pictures.h"

namespace vvr::test {

inline PixelBox whole(Size size) {
    return {0, 0, size.width, size.height};
}

/// The flow of frame `middle` in a part of it.
inline fields::Flow flow_in(fields::FlowMethod& method, std::span<const Plane<std::uint8_t>> frames, int middle,
                            const PixelBox& part) {
    std::vector<fields::FlowFrame> prepared;
    for (const Plane<std::uint8_t>& frame : frames) prepared.push_back(method.prepare(frame));
    std::vector<const fields::FlowFrame*> about;
    for (int k = middle - method.reach(); k <= middle + method.reach(); ++k) {
        about.push_back(&prepared[static_cast<std::size_t>(std::clamp(k, 0, static_cast<int>(prepared.size()) - 1))]);
    }
    return method(about, part);
}

/// The flow of frame `middle`.
inline fields::Flow flow_of(std::span<const Plane<std::uint8_t>> frames, int middle,
                            const fields::FlowOptions& options) {
    const auto method = fields::make_flow(options);
    return flow_in(*method, frames, middle, whole(frames.front().size()));
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
    double end_point = 0;  ///< pixels, mean
};

inline FlowError error_of(const fields::Flow& flow, double u, double v, int border) {
    double angle = 0, distance = 0;
    int count = 0;
    for (int j = border; j < flow.u.height() - border; ++j) {
        for (int i = border; i < flow.u.width() - border; ++i, ++count) {
            const double x = flow.u.at(i, j);
            const double y = flow.v.at(i, j);
            const double cosine = (x * u + y * v + 1) / std::sqrt((x * x + y * y + 1) * (u * u + v * v + 1));
            angle += std::acos(std::min(cosine, 1.0)) * 180 / std::numbers::pi;
            distance += std::hypot(x - u, y - v);
        }
    }
    return {angle / count, distance / count};
}

}  // namespace vvr::test
