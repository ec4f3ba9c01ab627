#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/fields/field_source.h"
#include "tests/scene/scene_source.h"
#include "tests/support/planes.h"

namespace vvr::test {

/// A grey plane whose value at each pixel is `value(i, j)`, rounded and cut to 0..255.
template <class Function>
Plane<std::uint8_t> grey_plane(Size size, Function value) {
    return plane_of<std::uint8_t>(size, [&](int i, int j) {
        return static_cast<std::uint8_t>(std::lround(std::fmin(std::fmax(value(i, j), 0), 255)));
    });
}

/// A texture of several wavelengths and directions, 8 px and longer, so that no direction of motion is hidden.
inline double texture(double x, double y) {
    return 128 + 40 * std::sin(x * 0.41 + y * 0.23) + 35 * std::sin(x * 0.19 - y * 0.37 + 1) +
           25 * std::sin(x * 0.53 - y * 0.07 + 2) + 20 * std::sin(x * 0.05 + y * 0.61);
}

/// A number between 0 and 1 for each whole (i, j).
inline double hash(int i, int j) {
    auto h = static_cast<std::uint32_t>(i) * 374761393U + static_cast<std::uint32_t>(j) * 668265263U;
    h = (h ^ (h >> 13)) * 1274126177U;
    return ((h ^ (h >> 16)) & 0xffffU) / 65535.0;
}

/// Smooth noise with one bump in every unit.
inline double bumps(double x, double y) {
    const int i = static_cast<int>(std::floor(x));
    const int j = static_cast<int>(std::floor(y));
    const double s = x - i, t = y - j;
    const double u = s * s * (3 - 2 * s), v = t * t * (3 - 2 * t);
    return (hash(i, j) * (1 - u) + hash(i + 1, j) * u) * (1 - v) +
           (hash(i, j + 1) * (1 - u) + hash(i + 1, j + 1) * u) * v;
}

/// A texture of all sizes that repeats nowhere, so that fast motion can be told.
inline double rough_texture(double x, double y) {
    return 20 + 100 * bumps(x / 17 + 50, y / 17 + 50) + 70 * bumps(x / 7 + 90, y / 7 + 20) +
           45 * bumps(x / 3.1 + 300, y / 3.1 + 77);
}

/// Frame `index` of the texture moving by (u, v) pixels per frame.
inline media::Frame texture_frame(Size size, std::int64_t index, double u, double v) {
    const auto f = static_cast<double>(index);
    return {index, f / 10, grey_plane(size, [&](int i, int j) { return texture(i - u * f, j - v * f); }), {}};
}

/// A frame of one grey level.
inline media::Frame flat_frame(Size size, std::int64_t index, std::uint8_t level) {
    return {index, static_cast<double>(index) / 10, Plane<std::uint8_t>(size, level), {}};
}

/// A frame as a camera would see it: in another light, with noise.
inline media::Frame seen(media::Frame frame, double gain, double offset, double sigma, std::mt19937& random) {
    std::normal_distribution<double> noise(0, sigma);
    for (std::uint8_t& p : frame.grey.pixels()) {
        p = static_cast<std::uint8_t>(std::lround(std::clamp(gain * p + offset + noise(random), 0.0, 255.0)));
    }
    return frame;
}

/// Frames that are made by their numbers.
inline fields::FrameReader frames_of(int count, const std::function<media::Frame(std::int64_t)>& make) {
    return [=, next = 0]() mutable -> fields::FrameJob {
        if (next == count) return {};
        return [make, index = next++] { return make(index); };
    };
}

/// A scene that is empty in a frame.
inline fields::EmptyScene scene_of(const media::Frame& empty) {
    fields::EmptyScene scene;
    scene.reference = fields::Planes{empty.grey, empty.colour};
    return scene;
}

inline std::vector<fields::Field> fields_of(const fields::FrameReader& frames, const fields::EmptyScene& scene,
                                            const fields::FieldOptions& options) {
    std::vector<fields::Field> fields;
    fields::compute_fields(frames, scene, options, [&](const media::SharedFrame& frame, fields::Field&& field) {
        EXPECT_EQ(frame->index, field.index);
        EXPECT_EQ(frame->grey.size(), field.scalar.size());
        fields.push_back(std::move(field));
    });
    return fields;
}

/// The fields of a generated scene in its own size and in colour.
inline std::vector<fields::Field> fields_of(const generator::Scene& scene, const fields::FieldOptions& options) {
    media::SourceOptions source{.field_size = {-1, -1}, .colour = true};
    std::vector<fields::Field> fields;
    fields::compute_fields(
        *generator::open_scene(scene, source), options,
        [&](const media::SharedFrame&, fields::Field&& field) { fields.push_back(std::move(field)); });
    return fields;
}

}  // namespace vvr::test
