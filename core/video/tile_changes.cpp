#include "core/video/tile_changes.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/video/tile_changes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vvr::HWY_NAMESPACE {

// Plain loops over the rows of a tile, of which the compiler makes vectors, for each kind of processor its own.
using Row = std::uint64_t;
using Tile = std::array<Row, change_side>;
static_assert(sizeof(Row) == change_side);

constexpr Row each(std::uint8_t byte) {
    return byte * Row{0x0101010101010101};
}

// Byte by byte, modulo 256.
HWY_INLINE Row sum(Row a, Row b) {
    return ((a & each(0x7f)) + (b & each(0x7f))) ^ ((a ^ b) & each(0x80));
}
HWY_INLINE Row difference(Row a, Row b) {
    return ((a | each(0x80)) - (b & each(0x7f))) ^ ((a ^ ~b) & each(0x80));
}

struct Width {
    int bits;
    std::uint8_t bias;  ///< makes differences that fit positive
};
constexpr std::array widths_there{Width{0, 0}, Width{2, 2}, Width{4, 8}, Width{8, 0}};

/// The low bits of a row's bytes, side by side.
template <int bits>
HWY_INLINE Row pack(Row row) {
    if constexpr (bits == 2) {
        row = (row | row >> 6U) & 0x000f000f000f000f;
        row = (row | row >> 12U) & 0x000000ff000000ff;
        return row | row >> 24U;
    }
    if constexpr (bits == 4) {
        row = (row | row >> 4U) & 0x00ff00ff00ff00ff;
        row = (row | row >> 8U) & 0x0000ffff0000ffff;
        return row | row >> 16U;
    }
    return row;
}

template <int bits>
HWY_INLINE Row unpack(Row row) {
    if constexpr (bits == 2) {
        row = (row | row << 24U) & 0x000000ff000000ff;
        row = (row | row << 12U) & 0x000f000f000f000f;
        return (row | row << 6U) & each(0x03);
    }
    if constexpr (bits == 4) {
        row = (row | row << 16U) & 0x0000ffff0000ffff;
        row = (row | row << 8U) & 0x00ff00ff00ff00ff;
        return (row | row << 4U) & each(0x0f);
    }
    return row;
}

template <int bits>
using Packed = std::conditional_t<bits == 2, std::uint16_t, std::conditional_t<bits == 4, std::uint32_t, Row>>;

template <class Byte>
HWY_INLINE int bytes_in(const Strip<Byte>& strip, int tile) {
    return std::min(change_side, strip.width - tile * change_side);
}

template <class Byte>
HWY_INLINE Tile load(const Strip<Byte>& strip, int tile) {
    const int bytes = bytes_in(strip, tile);
    Tile rows{};
    for (int j = 0; j < strip.height; ++j) {
        const Byte* const from = strip.row(j) + tile * change_side;
        Row& row = rows[static_cast<std::size_t>(j)];
        bytes == change_side ? std::memcpy(&row, from, change_side)
                             : std::memcpy(&row, from, static_cast<std::size_t>(bytes));
    }
    return rows;
}

HWY_INLINE void store(const Strip<std::uint8_t>& strip, int tile, const Tile& rows) {
    const int bytes = bytes_in(strip, tile);
    for (int j = 0; j < strip.height; ++j) {
        std::uint8_t* const to = strip.row(j) + tile * change_side;
        const Row& row = rows[static_cast<std::size_t>(j)];
        bytes == change_side ? std::memcpy(to, &row, change_side)
                             : std::memcpy(to, &row, static_cast<std::size_t>(bytes));
    }
}

template <std::size_t number>
HWY_INLINE std::uint8_t* write_tile(const Tile& now, const Tile& before, int rows, std::uint8_t* to) {
    constexpr Width width = widths_there[number];
    std::array<Packed<width.bits>, change_side> packed;
    for (std::size_t j = 0; j < change_side; ++j) {
        const Row biased = sum(difference(now[j], before[j]), each(width.bias));
        packed[j] = static_cast<Packed<width.bits>>(pack<width.bits>(biased));
    }
    const std::size_t bytes = sizeof packed[0] * static_cast<std::size_t>(rows);
    std::memcpy(to, packed.data(), bytes);
    return to + bytes;
}

template <std::size_t number>
HWY_INLINE const std::uint8_t* read_tile(Tile& tile, int rows, const std::uint8_t* from) {
    constexpr Width width = widths_there[number];
    std::array<Packed<width.bits>, change_side> packed{};
    const std::size_t bytes = sizeof packed[0] * static_cast<std::size_t>(rows);
    std::memcpy(packed.data(), from, bytes);
    for (std::size_t j = 0; j < change_side; ++j) {
        tile[j] = sum(tile[j], difference(unpack<width.bits>(packed[j]), each(width.bias)));
    }
    return from + bytes;
}

void gather(const std::uint8_t* HWY_RESTRICT now, const std::uint8_t* HWY_RESTRICT before, std::size_t width,
            std::uint8_t* HWY_RESTRICT none, std::uint8_t* HWY_RESTRICT two, std::uint8_t* HWY_RESTRICT four) {
    for (std::size_t i = 0; i < width; ++i) {
        const auto by = static_cast<std::uint8_t>(now[i] - before[i]);
        none[i] |= by;
        two[i] |= static_cast<std::uint8_t>((by + widths_there[1].bias) & 0xfc);
        four[i] |= static_cast<std::uint8_t>((by + widths_there[2].bias) & 0xf0);
    }
}

void choose(const Strip<const std::uint8_t>& now, const Strip<std::uint8_t>& before, std::span<std::uint8_t> widths) {
    const std::size_t bytes = widths.size() * change_side;
    // Of each byte what tells that a width is too small for it, for one width after another: not 0.
    std::vector<std::uint8_t> exceeding(3 * bytes);
    std::uint8_t* const none = exceeding.data();
    std::uint8_t* const two = none + bytes;
    std::uint8_t* const four = two + bytes;
    for (int j = 0; j < now.height; ++j) {
        gather(now.row(j), before.row(j), static_cast<std::size_t>(now.width), none, two, four);
    }
    for (std::size_t tile = 0; tile < widths.size(); ++tile) {
        // What is too large for a width is too large for all that are smaller.
        int number = 0;
        for (const std::uint8_t* bits : {none, two, four}) {
            Row row = 0;
            std::memcpy(&row, bits + tile * change_side, change_side);
            number += row != 0 ? 1 : 0;
        }
        widths[tile] = static_cast<std::uint8_t>(number);
    }
}

std::uint8_t* write_strip(const Strip<const std::uint8_t>& now, const Strip<std::uint8_t>& before,
                          std::span<std::uint8_t> widths, std::uint8_t* to) {
    choose(now, before, widths);
    for (int tile = 0; tile < now.tiles(); ++tile) {
        const std::uint8_t number = widths[static_cast<std::size_t>(tile)];
        if (number == 0) continue;
        const Tile rows = load(now, tile);
        const Tile old = load(before, tile);
        if (number == 1) to = write_tile<1>(rows, old, now.height, to);
        if (number == 2) to = write_tile<2>(rows, old, now.height, to);
        if (number == 3) to = write_tile<3>(rows, old, now.height, to);
        store(before, tile, rows);
    }
    return to;
}

const std::uint8_t* read_strip(const Strip<std::uint8_t>& strip, std::span<const std::uint8_t> widths,
                               const std::uint8_t* from) {
    for (int tile = 0; tile < strip.tiles(); ++tile) {
        const std::uint8_t number = widths[static_cast<std::size_t>(tile)];
        if (number == 0) continue;
        Tile rows = load(strip, tile);
        if (number == 1) from = read_tile<1>(rows, strip.height, from);
        if (number == 2) from = read_tile<2>(rows, strip.height, from);
        if (number == 3) from = read_tile<3>(rows, strip.height, from);
        store(strip, tile, rows);
    }
    return from;
}

}  // namespace vvr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vvr {

HWY_EXPORT(write_strip);
HWY_EXPORT(read_strip);

std::uint8_t* write_changes(const Strip<const std::uint8_t>& now, const Strip<std::uint8_t>& before,
                            std::span<std::uint8_t> widths, std::uint8_t* to) {
    return HWY_DYNAMIC_DISPATCH(write_strip)(now, before, widths, to);
}

const std::uint8_t* read_changes(const Strip<std::uint8_t>& strip, std::span<const std::uint8_t> widths,
                                 const std::uint8_t* from) {
    return HWY_DYNAMIC_DISPATCH(read_strip)(strip, widths, from);
}

}  // namespace vvr
#endif
