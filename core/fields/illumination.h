#pragma once

#include <span>
#include <string_view>

#include "core/fields/planes.h"

namespace vvr {

/// How the light, or the camera's exposure, has changed: a level L has become `gain` L + `offset`.
struct Light {
    double gain = 1;
    double offset = 0;  ///< grey levels

    friend bool operator==(const Light&, const Light&) = default;
};

/// The change from `reference` to `frame`, from what became of each level of grey in most places. It stands as long
/// as objects cover less than half of the places of most levels; exactly `Light{}` for changes too small to see.
Light light_between(const Planes& reference, const Planes& frame);

/// One row of the illumination table: how a change of light between reference and frame is told from an object.
struct IlluminationRow {
    std::string_view name;
    std::string_view help;
    bool compensates;
    /// What the picture `reference` would look like in the light of `frame`.
    Planes (*relit)(const Planes& reference, const Planes& frame);
};

/// "global", "local", "none". §8 of the paper names changing light as an unsolved weakness.
std::span<const IlluminationRow> illuminations();

}  // namespace vvr
