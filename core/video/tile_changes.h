#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

// What a picture differs by from another, tile by tile: in 0, 2, 4 or 8 bits a byte, as noise and what a decoder mends
// is mostly small.
namespace vvr {

/// Rows and columns of bytes in a tile.
inline constexpr int change_side = 8;

/// Rows of a plane, as many as a tile has, or fewer at its lower edge.
template <class Byte>
struct Strip {
    Byte* first = nullptr;
    std::ptrdiff_t stride = 0;
    int width = 0;  ///< bytes
    int height = 0;

    int tiles() const { return (width + change_side - 1) / change_side; }
    Byte* row(int j) const { return first + j * stride; }
};

/// Writes by what `now` differs from `before`, which becomes the same.
/// \param widths one for each tile: what to read it with, 0 where nothing differs, at most 3
/// \param to room for all bytes of the strip's tiles
/// \returns the end of what it wrote
std::uint8_t* write_changes(const Strip<const std::uint8_t>& now, const Strip<std::uint8_t>& before,
                            std::span<std::uint8_t> widths, std::uint8_t* to);

/// Changes a strip by what `write_changes` wrote.
/// \returns the end of what it read
const std::uint8_t* read_changes(const Strip<std::uint8_t>& strip, std::span<const std::uint8_t> widths,
                                 const std::uint8_t* from);

}  // namespace vvr
