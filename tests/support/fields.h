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

/// 100 frames, of which some are missing.
inline volume::Volume volume_with_gap(int begin, int end, std::int64_t capacity = 800) {
    volume::Volume volume({32, 24}, {capacity});
    for (int i = 0; i < 100; ++i) {
        if (i < begin || i >= end) {
            volume.add(field_of(i, {32, 24}, 200));
        } else {
            volume.add_missing(i, i / 25.0);
        }
    }
    return volume;
}

/// Three minutes of motion, each after an hour of nothing, a frame per second.
inline volume::Volume day_with_pauses(std::int64_t capacity) {
    volume::Volume volume({32, 24}, {.capacity = capacity, .nonuniform = true});
    for (int i = 0; i < 3 * 3780; ++i) {
        fields::Field field{i, 1.0 * i, Plane<std::uint8_t>({32, 24}), {}, {}};
        const bool moves = i % 3780 >= 3600;
        if (moves) field.scalar.at(i % 32, i % 24) = 200;
        volume.add(field, {}, {}, moves);
    }
    volume.settle();
    return volume;
}

}  // namespace vvr::test
