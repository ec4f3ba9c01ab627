#pragma once

#include <span>
#include <string_view>

#include "core/fields/planes.h"

namespace vvr::fields {

/// One row of the table of norms: how much two pictures differ at a pixel, in levels 0 to 255.
struct NormRow {
    std::string_view name;
    std::string_view help;
    bool needs_colour;
    Plane<std::uint8_t> (*difference)(const Planes& a, const Planes& b);
};

/// The norms; the first is the default.
std::span<const NormRow> norms();

/// The row of that name, for pictures like this one.
/// \throws Error usage when there is none, or it needs colour and the picture has none
const NormRow& find_norm(std::string_view name, const Planes& picture);

}  // namespace vvr::fields
