#pragma once

#include <utility>

#include "core/volume/volume.h"

namespace vvr::test {

/// The field of a frame; there are 25 a second.
inline fields::Field field_of(std::int64_t index, Plane<std::uint8_t> scalar) {
    return {index, static_cast<double>(index) / 25, std::move(scalar), {}, {}};
}

/// A field of one value.
inline fields::Field field_of(std::int64_t index, Size size, std::uint8_t value = 0) {
    return field_of(index, Plane<std::uint8_t>(size, value));
}

/// A volume of frames of one value, each a layer while it has room.
inline volume::Volume even_volume(Size size, int frames, std::uint8_t value = 0, std::int64_t capacity = 800) {
    volume::Volume volume(size, {capacity});
    for (int i = 0; i < frames; ++i) volume.add(field_of(i, size, value));
    return volume;
}

}  // namespace vvr::test
