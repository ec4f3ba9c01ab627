#include "core/fields/reference.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vvr {
namespace {

// Finds the median bit by bit, from the highest: a bit is set when more than half of the values reach it. Every
// loop runs along the row, so the compiler makes vectors of them; sorting each pixel's values takes 40 times as long.
void median_row(std::span<const std::uint8_t* const> rows, std::span<std::uint8_t> median) {
    const auto needed = static_cast<std::uint16_t>((rows.size() + 1) / 2);
    std::vector<std::uint16_t> reached(median.size());
    std::ranges::fill(median, std::uint8_t{0});
    for (int bit = 128; bit != 0; bit /= 2) {
        std::ranges::fill(reached, std::uint16_t{0});
        for (const std::uint8_t* row : rows) {
            for (std::size_t i = 0; i < median.size(); ++i) reached[i] += row[i] >= (median[i] | bit);
        }
        for (std::size_t i = 0; i < median.size(); ++i) {
            if (reached[i] >= needed) median[i] = static_cast<std::uint8_t>(median[i] | bit);
        }
    }
}

std::span<std::uint8_t> bytes(std::span<std::uint8_t> row) {
    return row;
}
std::span<std::uint8_t> bytes(std::span<Bgr> row) {
    return {row.front().data(), row.size() * 3};
}
const std::uint8_t* first_byte(std::span<const std::uint8_t> row) {
    return row.data();
}
const std::uint8_t* first_byte(std::span<const Bgr> row) {
    return row.front().data();
}

template <class Pixel>
Plane<Pixel> median(std::span<const Frame> frames, Plane<Pixel> Frame::*plane) {
    Plane<Pixel> result((frames.front().*plane).size());
    std::vector<const std::uint8_t*> rows(frames.size());
    for (int j = 0; j < result.height(); ++j) {
        std::ranges::transform(frames, rows.begin(), [&](const Frame& f) { return first_byte((f.*plane).row(j)); });
        median_row(rows, bytes(result.row(j)));
    }
    return result;
}

}  // namespace

Reference median_reference(std::span<const Frame> frames) {
    if (frames.empty()) return {};
    return {median(frames, &Frame::grey), median(frames, &Frame::colour)};
}

}  // namespace vvr
