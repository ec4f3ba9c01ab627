#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/fields/planes.h"

namespace vvr::fields {

/// One row of the table of shadow treatments.
struct ShadowRow {
    std::string_view name;
    std::string_view help;
    bool removes;
};

/// "remove", "keep".
std::span<const ShadowRow> shadow_kinds();

/// A pixel that was removed from the difference object as a shadow, and its value.
struct ShadowPixel {
    int i, j;
    std::uint8_t value;
};

/// Removes cast shadows from `object`: pixels that are darker than the scene by nearly the same ratio in all channels,
/// down to a little less than half (after Horprasert, Harwood and Davis, ICCV 1999). Does nothing where
/// the frame or the scene has no colours: there a shadow looks like any dark object.
/// \param empty the empty scene in the light of `frame`
/// \param faint smaller values of the object may be a shadow's soft edge
/// \returns the removed pixels, by rows
std::vector<ShadowPixel> extract_shadows(Plane<std::uint8_t>& object, const Planes& frame, const Planes& empty,
                                         std::uint8_t faint);

/// Restores removed pixels that `object` encloses: with object pixels within `reach` pixels below and in two more of
/// the four directions. The roof of a grey car on a grey road looks like a shadow, but a shadow lies beside or under
/// its object, not inside. Values below `faint` are not restored.
void restore_enclosed(Plane<std::uint8_t>& object, std::span<const ShadowPixel> shadow, int reach, std::uint8_t faint);

}  // namespace vvr::fields
