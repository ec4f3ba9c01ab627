#pragma once

#include <cstdint>

#include "core/bricks/volume.h"

namespace vvr::test {

/// A frame of one value, a tenth of a second after the one before.
inline fields::Field frame(int index, Size size, std::uint8_t value) {
    fields::Field field;
    field.index = index;
    field.pts = 0.1 * index;
    field.scalar = Plane<std::uint8_t>(size, value);
    return field;
}

}  // namespace vvr::test
