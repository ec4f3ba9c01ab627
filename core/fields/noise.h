#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/fields/planes.h"
#include "core/video/frame.h"

namespace vvr::fields {

/// For each column, the largest value that at least `needed` of the rows reach: of n rows, (n + 1) / 2 gives the
/// median. It is found bit by bit, from the highest. Every loop runs along the row, so the compiler vectorizes it;
/// sorting each pixel's values takes 40 times as long.
inline void rank_rows(std::span<const std::uint8_t* const> rows, std::size_t needed, std::span<std::uint8_t> result) {
    std::vector<std::uint16_t> reached(result.size());
    std::ranges::fill(result, std::uint8_t{0});
    for (int bit = 128; bit != 0; bit /= 2) {
        std::ranges::fill(reached, std::uint16_t{0});
        for (const std::uint8_t* row : rows) {
            for (std::size_t i = 0; i < result.size(); ++i) reached[i] += row[i] >= (result[i] | bit);
        }
        for (std::size_t i = 0; i < result.size(); ++i) {
            if (reached[i] >= needed) result[i] = static_cast<std::uint8_t>(result[i] | bit);
        }
    }
}

/// The usual deviation of each pixel from the empty scene, grey levels: camera noise, and more where leaves sway or
/// edges tremble. It is roughly the median deviation, taken from the third of the frames that deviate least, so that an
/// object that is present most of the time doesn't count; from fewer frames where an object stays even longer.
/// \param frames under the same light and, if the camera shakes, aligned
/// \param scene the empty scene, smoothed by `smooth` as the frames will be
/// \returns empty if there are too few frames
Plane<std::uint8_t> noise_of(std::span<const video::Frame> frames, const Planes& scene, double smooth);

}  // namespace vvr::fields
