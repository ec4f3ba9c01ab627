#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/fields/field.h"
#include "core/fields/options.h"

namespace vvr::fields {

/// What is known of one frame when its seeds are chosen. All planes are of one size.
struct SeedInput {
    std::int64_t index = 0;  ///< of the frame
    const Flow& flow;
    const Plane<std::uint8_t>& object;  ///< where it isn't 0 there is one; its value is the criterion "difference"
    const Plane<std::uint16_t>& age;    ///< frames for which a point has been part of an object; may be empty
};

/// One row of the table of seed orders. The largest weight comes first.
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
    bool object_alone;  ///< seeds lie where there is an object
};

/// The areas; the first is the default.
std::span<const SeedAreaRow> seed_areas();

/// One more where there is an object, 0 elsewhere: SeedInput::age of the next frame.
/// \param before empty at the first frame
Plane<std::uint16_t> aged(const Plane<std::uint16_t>& before, const Plane<std::uint8_t>& object);

/// \throws Error usage for anything but "all", "first:N", "random:N", "random:N:NUMBER"
SeedSelection parse_seed_selection(const std::string& text);

/// The seeds of one frame by the three phases of §4.2: points of a grid that lie in the area and move by the
/// least magnitude or more; in order, the most important first; of which some are taken. Random ones depend on the
/// frame's index and the seed number alone, and keep their order.
std::vector<Seed> make_seeds(const SeedInput& input, const SeedOptions& options);

}  // namespace vvr::fields
