#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/fields/field.h"
#include "core/fields/options.h"

namespace vvr::fields {

/// The input of seed selection for one frame. All planes have the same size.
struct SeedInput {
    std::int64_t index = 0;  ///< number of the frame
    const Flow& flow;
    const Plane<std::uint8_t>& object;  ///< not 0 where there is an object; its value is the criterion "difference"
    const Plane<std::uint16_t>& age;    ///< number of frames for which a point has been part of an object; may be empty
};

/// One row of the table of seed orders. Seeds are sorted by weight, the largest first.
struct SeedOrderRow {
    std::string_view name;
    std::string_view help;
    bool needs_age;
    float (*weight)(const SeedInput& input, int i, int j);
};

std::span<const SeedOrderRow> seed_orders();

/// One row of the table of seed areas.
struct SeedAreaRow {
    std::string_view name;
    std::string_view help;
    bool object_alone;  ///< seeds lie on objects only
};

/// All areas; the first is the default.
std::span<const SeedAreaRow> seed_areas();

/// The next frame's SeedInput::age: one more where there is an object, 0 elsewhere.
/// \param before age of this frame; empty at the first frame
Plane<std::uint16_t> aged(const Plane<std::uint16_t>& before, const Plane<std::uint8_t>& object);

/// Parses "all", "first:N", "random:N" or "random:N:NUMBER".
/// \throws Error usage for any other text
SeedSelection parse_seed_selection(const std::string& text);

/// The seeds of one frame, by the three phases of §4.2: finds the grid points in the area with at least the minimum
/// magnitude, sorts them by importance, selects some. A random selection depends only on the frame's number and the
/// seed number, and keeps the order.
std::vector<Seed> make_seeds(const SeedInput& input, const SeedOptions& options);

}  // namespace vvr::fields
