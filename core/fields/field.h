#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/plane.h"

namespace vvr::fields {

/// Neighbouring pixels of one row that belong to one track: columns first to last - 1.
struct LabelRun {
    int row = 0;
    int first = 0;
    int last = 0;
    std::size_t track = 0;
};

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

/// In which bricks a seed makes geometry (§6): a digit 0 or 1 per brick, from the clip's first brick on; after the last
/// digit they begin again. By default it does in all.
class SeedFlags {
  public:
    static constexpr int most = 32;  ///< digits

    SeedFlags() = default;

    /// Of `1`, `0` or `100`; nothing for what isn't 1 to `most` digits 0 and 1.
    static std::optional<SeedFlags> parse(std::string_view digits);

    bool in(std::int64_t brick) const { return ((digits_ >> static_cast<unsigned>(brick % count_)) & 1U) != 0; }

    std::string text() const;

    friend bool operator==(const SeedFlags&, const SeedFlags&) = default;

  private:
    std::uint32_t digits_ = 1;  ///< the first in the lowest bit
    int count_ = 1;
};

/// Optical flow of one frame in field pixels per frame, u to the right, v down (the convention of .flo files).
struct Flow {
    Plane<float> u;
    Plane<float> v;
};

/// A point of the flow field at which a glyph or a traceline starts (§4.2).
struct Seed {
    float x = 0;  ///< column in field pixels, the centre of the first pixel is 0
    float y = 0;  ///< row in field pixels, from the top
    float u = 0;  ///< flow at the point, pixels per frame
    float v = 0;
    SeedFlags flags{};  ///< whether the brick that the frame falls in makes geometry of it (§6)

    friend bool operator==(const Seed&, const Seed&) = default;
};

/// What the video sub-system gives for one frame.
struct Field {
    std::int64_t index = 0;        ///< of the frame in the clip
    double pts = 0;                ///< seconds
    Plane<std::uint8_t> scalar;    ///< 0 = uninteresting
    Flow flow;                     ///< empty where no flow was asked for; else 0 far from any object, unless asked for
    std::vector<Seed> seeds;       ///< empty where no flow was asked for
    Plane<std::uint8_t> second{};  ///< what a second filter gives; empty where none was asked for
};

}  // namespace vvr::fields
