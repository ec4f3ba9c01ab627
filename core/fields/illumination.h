#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/fields/planes.h"

namespace vvr::fields {

/// How the light, or the camera's exposure, has changed: a level L has become `gain` L + `offset`.
struct IlluminationChange {
    double gain = 1;
    double offset = 0;  ///< grey levels

    friend bool operator==(const IlluminationChange&, const IlluminationChange&) = default;

    double operator()(double level) const { return gain * level + offset; }

    /// Whether it makes a difference of a level somewhere.
    bool is_visible() const { return std::abs(offset) >= 1 || std::abs((*this)(255) - 255) >= 1; }
};

/// The change from `reference` to `frame`, from what became of each level of grey in most places. It holds as long
/// as objects cover less than half of the places of most levels; `IlluminationChange{}` where there is nothing to learn
/// from.
IlluminationChange estimate_illumination(const Planes& reference, const Planes& frame);

/// The levels below which 5 %, 10 %, ... 95 % of a picture's pixels lie.
using Quantiles = std::array<float, 19>;
Quantiles quantiles_of(const Plane<std::uint8_t>& grey);

/// Whether the light jumps between two frames near each other: by three levels or more for most pixels. Unlike
/// `estimate_illumination` it compares no pixel with itself, so it holds when everything moves.
bool illumination_jumps(const Quantiles& from, const Quantiles& to);

/// A picture as it would look in another light.
Planes relight(const Planes& picture, const IlluminationChange& light);

/// One row of the illumination table: how to know a change of light between reference and frame from an object.
struct IlluminationRow {
    std::string_view name;
    std::string_view help;
    bool compensates;
    /// The picture `reference` in the light of `frame`, which has changed by `light` on the whole; nothing where it
    /// would be the same.
    std::optional<Planes> (*relit)(const Planes& reference, const Planes& frame, const IlluminationChange& light);
};

/// "global", "local", "none". §8 of the paper names changing light as an unsolved weakness.
std::span<const IlluminationRow> illuminations();

}  // namespace vvr::fields
