#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace vvr::fields {

/// What the values of a scalar field are. 0 is nothing in each.
enum class Values {
    strength,  ///< more is stronger, and between two values are others
    band,      ///< names, those of Band: nothing is between them
    sign,      ///< strengths on both sides of `sign_middle`, which is as weak as nothing
};

/// Values of the `bands` filter, a 4-band difference volume: what became of a pixel from one frame to the next.
enum class Band : std::uint8_t { background = 0, uncovered = 85, still_covered = 170, newly_covered = 255 };

/// The band of a pixel that was covered then, and is now.
constexpr Band band_of(bool then, bool now) {
    if (now) return then ? Band::still_covered : Band::newly_covered;
    return then ? Band::uncovered : Band::background;
}

/// Of Values::sign.
inline constexpr int sign_middle = 128;

/// Whether there is something between two values next to each other. Else each voxel is drawn as it is.
constexpr bool interpolates(Values values) {
    return values == Values::strength;
}

/// What a pixel of a layer shows that had a value, and has another in a later frame. Strengths: the stronger. Bands:
/// what became of it from before the first frame to the last; what came and went between them counts as newly covered,
/// so that nothing is lost.
constexpr std::uint8_t joined(Values values, std::uint8_t before, std::uint8_t after) {
    const bool one_is_nothing = before == 0 || after == 0;
    if (values == Values::strength || (values == Values::sign && one_is_nothing)) return std::max(before, after);
    if (values == Values::sign) return std::abs(after - sign_middle) > std::abs(before - sign_middle) ? after : before;
    const auto first = static_cast<Band>(before);
    const auto last = static_cast<Band>(after);
    const bool then = first == Band::uncovered || first == Band::still_covered;
    const bool now = last == Band::newly_covered || last == Band::still_covered;
    const bool came_and_went = !then && !now && (before != 0 || after != 0);
    return static_cast<std::uint8_t>(came_and_went ? Band::newly_covered : band_of(then, now));
}

}  // namespace vvr::fields
