#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/fields/planes.h"

namespace vvr::fields {

/// A change of the light or of the camera's exposure: level L becomes `gain` L + `offset`.
struct IlluminationChange {
    double gain = 1;
    double offset = 0;  ///< grey levels

    friend bool operator==(const IlluminationChange&, const IlluminationChange&) = default;

    double operator()(double level) const { return gain * level + offset; }

    /// Whether it changes any level by at least 1.
    bool is_visible() const { return std::abs(offset) >= 1 || std::abs((*this)(255) - 255) >= 1; }
};

/// Estimates the change from `reference` to `frame`, from the median change of each grey level. Valid while objects
/// cover less than half of the pixels of most levels.
/// \returns `IlluminationChange{}` where nothing can be learnt
IlluminationChange estimate_illumination(const Planes& reference, const Planes& frame);

/// The grey levels below which 5 %, 10 %, … 95 % of a picture's pixels lie.
using Quantiles = std::array<float, 19>;
Quantiles quantiles_of(const Plane<std::uint8_t>& grey);

/// Whether the light jumps between two nearby frames: by three levels or more for most quantiles. It compares
/// distributions, not pixels, so it also works when everything moves.
bool illumination_jumps(const Quantiles& from, const Quantiles& to);

/// A picture under changed light.
Planes relight(const Planes& picture, const IlluminationChange& light);

/// `reference` in the light of `frame`, whose global change is `light`; nothing where it would not change.
std::optional<Planes> relit(const Planes& reference, const Planes& frame, const IlluminationChange& light);

/// Light that differs over the picture: the shadow of a cloud, a lamp at one side.
struct LocalLight {
    Plane<float> gains;    ///< of blocks all over the picture
    double explained = 0;  ///< share of the object's textured blocks that still have the reference's texture;
                           ///< if less than half of its blocks are textured, of that half
    double changed = 0;    ///< share of the picture that is in another light
};

/// Compares a frame with a reference that has its light on the whole.
/// \param object what differs between them; not 0 = it does
LocalLight local_light(const Planes& reference, const Planes& frame, const Plane<std::uint8_t>& object);

Planes relight(const Planes& picture, const LocalLight& light);

/// One row of the table of illuminations: how to distinguish a change of light from an object.
struct IlluminationRow {
    std::string_view name;
    std::string_view help;
    bool compensates;
    double local;  ///< share of the picture that must have changed before the light is estimated block by block
};

/// "global", "local", "none". §8 of the paper calls changing light an unsolved weakness.
std::span<const IlluminationRow> illuminations();

}  // namespace vvr::fields
