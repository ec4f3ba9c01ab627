#pragma once

#include <span>
#include <string_view>

#include "core/fields/planes.h"

namespace vvr {

/// One row of the illumination table: how a change of light between reference and frame is told from an object.
struct IlluminationRow {
    std::string_view name;
    std::string_view help;
    bool compensates;
    /// What the picture `reference` would look like in the light of `frame`.
    Planes (*relit)(const Planes& reference, const Planes& frame);
};

/// "none", "global", "local". §8 of the paper names changing light as an unsolved weakness.
std::span<const IlluminationRow> illuminations();

/// How much brighter `frame` is than `reference`: the median of the ratios of their grey levels, between 0.4 and 2.5,
/// and 1 for changes too small to see. It stands as long as objects cover less than half of the picture.
double light_gain(const Planes& reference, const Planes& frame);

}  // namespace vvr
