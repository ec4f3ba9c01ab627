#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/fields/planes.h"

namespace vvr::fields {

/// One row of the table of shadows.
struct ShadowRow {
    std::string_view name;
    std::string_view help;
    bool removes;
};

/// "remove", "keep".
std::span<const ShadowRow> shadow_kinds();

/// A pixel of the difference object that looks like a shadow, and the value it had.
struct ShadowPixel {
    int i, j;
    std::uint8_t value;
};

/// Takes out of `object` what looks like a cast shadow: there the scene is darker by nearly the same share in all
/// channels, down to a little less than half (after Horprasert, Harwood and Davis, ICCV 1999). Does nothing to frames
/// without colour, in which a shadow looks like any dark thing.
/// \param empty the empty scene in the light of `frame`
/// \param faint values of the object below it may be a shadow's soft edge
/// \returns what was taken out, by rows
std::vector<ShadowPixel> extract_shadows(Plane<std::uint8_t>& object, const Planes& frame, const Planes& empty,
                                         std::uint8_t faint);

/// Gives back to `object` what has something of it within `reach` pixels below and in two more of the four directions:
/// a grey car's roof on a grey road looks like a shadow, but a shadow lies beside or under its thing, not within it.
/// What is below `faint` stays out.
void restore_enclosed(Plane<std::uint8_t>& object, std::span<const ShadowPixel> shadow, int reach, std::uint8_t faint);

}  // namespace vvr::fields
