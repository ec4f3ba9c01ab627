#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/plane.h"
#include "core/fields/planes.h"
#include "core/media/frame.h"

namespace vvr::fields {

/// A run of pixels of one track in one row: columns first to last - 1.
struct LabelRun {
    int row = 0;
    int first = 0;
    int last = 0;
    std::size_t track = 0;
};

/// The meaning of a scalar field's values. 0 is always background.
enum class Values {
    strength,  ///< larger is stronger; values can be interpolated
    band,      ///< labels, those of Band; they can't be interpolated
    sign,      ///< signed strengths around `sign_middle`, which is as weak as 0
};

/// Values of the `bands` filter (4-band difference volume): how a pixel changed from one frame to the next.
enum class Band : std::uint8_t { background = 0, uncovered = 85, still_covered = 170, newly_covered = 255 };

/// The band of a pixel from its state before and now.
constexpr Band band_of(bool then, bool now) {
    if (now) return then ? Band::still_covered : Band::newly_covered;
    return then ? Band::uncovered : Band::background;
}

/// The zero of Values::sign.
inline constexpr int sign_middle = 128;

/// Whether neighbouring values are interpolated. If not, each voxel is drawn with its own value.
constexpr bool interpolates(Values values) {
    return values == Values::strength;
}

/// Merges a pixel's values of two frames that share a layer. Strengths: the larger. Signs: the one farther from the
/// middle. Bands: the change from before the first frame to the last; a pixel that was covered only in between counts
/// as newly covered, so that nothing is lost.
constexpr std::uint8_t joined(Values values, std::uint8_t before, std::uint8_t after) {
    const bool one_is_zero = before == 0 || after == 0;
    if (values == Values::strength || (values == Values::sign && one_is_zero)) return std::max(before, after);
    if (values == Values::sign) return std::abs(after - sign_middle) > std::abs(before - sign_middle) ? after : before;
    const auto first = static_cast<Band>(before);
    const auto last = static_cast<Band>(after);
    const bool then = first == Band::uncovered || first == Band::still_covered;
    const bool now = last == Band::newly_covered || last == Band::still_covered;
    const bool came_and_went = !then && !now && (before != 0 || after != 0);
    return static_cast<std::uint8_t>(came_and_went ? Band::newly_covered : band_of(then, now));
}

/// The bricks in which a seed makes geometry (§6): one digit, 0 or 1, per brick. The first digit is for the clip's
/// first brick, and the digits repeat. Default: all bricks.
class SeedFlags {
  public:
    static constexpr int most = 32;  ///< digits

    SeedFlags() = default;

    /// Parses digits such as `1` or `100`; nothing unless they are 1 to `most` digits 0 and 1.
    static std::optional<SeedFlags> parse(std::string_view digits) {
        if (digits.empty() || digits.size() > most) return std::nullopt;
        if (digits.find_first_not_of("01") != std::string_view::npos) return std::nullopt;
        SeedFlags flags;
        flags.digits_ = 0;
        flags.count_ = static_cast<int>(digits.size());
        for (std::size_t i = 0; i < digits.size(); ++i) flags.digits_ |= (digits[i] == '1' ? 1U : 0U) << i;
        return flags;
    }

    bool in(std::int64_t brick) const { return ((digits_ >> static_cast<unsigned>(brick % count_)) & 1U) != 0; }

    std::string text() const {
        std::string digits;
        for (int i = 0; i < count_; ++i) digits += in(i) ? '1' : '0';
        return digits;
    }

    friend bool operator==(const SeedFlags&, const SeedFlags&) = default;

  private:
    std::uint32_t digits_ = 1;  ///< the first digit in the lowest bit
    int count_ = 1;
};

/// Optical flow of one frame, field pixels per frame: u to the right, v down (the convention of .flo files).
struct Flow {
    Plane<float> u;
    Plane<float> v;
};

/// A point of the flow field at which a glyph or a traceline starts (§4.2).
struct Seed {
    float x = 0;  ///< column, field pixels; the centre of the first pixel is 0
    float y = 0;  ///< row, field pixels, from the top
    float u = 0;  ///< flow at the point, field pixels per frame
    float v = 0;
    SeedFlags flags{};  ///< the bricks in which it makes geometry (§6)

    friend bool operator==(const Seed&, const Seed&) = default;
};

/// An empty scene that was learnt anew, because most of the picture had changed and stayed so.
struct NewScene {
    Planes planes;
    double changed = 0;  ///< when, seconds
};

/// The output of the video sub-system for one frame.
struct Field {
    std::int64_t index = 0;        ///< number of the frame in the clip
    double pts = 0;                ///< seconds
    Plane<std::uint8_t> scalar;    ///< 0 = uninteresting
    Flow flow;                     ///< empty if not requested; 0 far from objects unless requested there
    std::vector<Seed> seeds;       ///< empty if no flow was requested
    Plane<std::uint8_t> second{};  ///< output of the second filter; empty if there is none
    std::size_t view = 0;    ///< the view of the camera with whose empty scene it was compared, as `Reference::of_view`
    double other_light = 0;  ///< share of the picture that is in another light than its empty scene
    condition::Kind before = condition::Kind::no_signal;  ///< why frames before it are missing, if some are
    std::optional<double> absent_since{};                 ///< seconds; when that began, if before the last frame
    std::shared_ptr<const NewScene> scene{};              ///< with which it is the first to be compared; usually null
};

/// Receives each frame with its field, in frame order, from one thread at a time.
using FieldSink = std::function<void(const media::SharedFrame&, Field&&)>;

}  // namespace vvr::fields
