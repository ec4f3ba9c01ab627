#include "core/video/frame_store.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <sys/mman.h>

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/imgutils.h>
#include <libavutil/pixdesc.h>
}

#include "core/error.h"
#include "core/video/av.h"

namespace vvr {
namespace {

// A tile is as wide as a word is long, so that a word is a row of it.
using Row = std::uint64_t;
constexpr int side = sizeof(Row);

constexpr Row each(std::uint8_t byte) {
    return byte * Row{0x0101010101010101};
}

// Byte by byte, modulo 256.
Row add(Row a, Row b) {
    return ((a & each(0x7f)) + (b & each(0x7f))) ^ ((a ^ b) & each(0x80));
}
Row subtract(Row a, Row b) {
    return ((a | each(0x80)) - (b & each(0x7f))) ^ ((a ^ ~b) & each(0x80));
}

/// How a tile is written: what it differs by, in so many bits a byte. Noise and what a decoder mends is mostly small.
struct Width {
    int bits;
    std::uint8_t bias;  ///< makes differences that fit positive
};
constexpr std::array widths{Width{0, 0}, Width{2, 2}, Width{4, 8}, Width{8, 0}};

/// Calls visit(width) with a constant, of whose shifts and copies the compiler makes few instructions.
template <class Visit>
void with_width(unsigned number, const Visit& visit) {
    if (number == 1) visit(std::integral_constant<std::size_t, 1>());
    if (number == 2) visit(std::integral_constant<std::size_t, 2>());
    if (number == 3) visit(std::integral_constant<std::size_t, 3>());
}

/// The low bits of 8 bytes, side by side.
template <int bits>
Row pack(Row row) {
    if constexpr (bits == 2) {
        row = (row | row >> 6U) & 0x000f000f000f000f;
        row = (row | row >> 12U) & 0x000000ff000000ff;
        return (row | row >> 24U) & 0xffff;
    }
    if constexpr (bits == 4) {
        row = (row | row >> 4U) & 0x00ff00ff00ff00ff;
        row = (row | row >> 8U) & 0x0000ffff0000ffff;
        return (row | row >> 16U) & 0xffffffff;
    }
    return row;
}

template <int bits>
Row unpack(Row row) {
    if constexpr (bits == 2) {
        row = (row | row << 24U) & 0x000000ff000000ff;
        row = (row | row << 12U) & 0x000f000f000f000f;
        return (row | row << 6U) & 0x0303030303030303;
    }
    if constexpr (bits == 4) {
        row = (row | row << 16U) & 0x0000ffff0000ffff;
        row = (row | row << 8U) & 0x00ff00ff00ff00ff;
        return (row | row << 4U) & 0x0f0f0f0f0f0f0f0f;
    }
    return row;
}

// Whichever end of a word comes first in memory, its low bytes are what is written.
template <int bytes>
constexpr std::size_t low_bytes_at = std::endian::native == std::endian::little ? 0 : sizeof(Row) - bytes;

template <int bytes>
std::uint8_t* put(Row row, std::uint8_t* to) {
    const auto memory = std::bit_cast<std::array<std::uint8_t, sizeof(Row)>>(row);
    std::memcpy(to, memory.data() + low_bytes_at<bytes>, bytes);
    return to + bytes;
}

template <int bytes>
Row get(const std::uint8_t*& from) {
    std::array<std::uint8_t, sizeof(Row)> memory{};
    std::memcpy(memory.data() + low_bytes_at<bytes>, from, bytes);
    from += bytes;
    return std::bit_cast<Row>(memory);
}

/// Tiles beside each other, as far as a plane reaches.
struct Strip {
    int plane;
    int y;
    int width;   ///< bytes
    int height;  ///< at most `side`

    int tiles() const { return (width + side - 1) / side; }

    std::uint8_t* row(const AVFrame& picture, int j) const {
        return picture.data[plane] + std::ptrdiff_t{y + j} * picture.linesize[plane];
    }

    Row load(const AVFrame& picture, int tile, int j) const {
        const std::uint8_t* const from = row(picture, j) + std::ptrdiff_t{tile} * side;
        Row value = 0;
        if (width - tile * side >= side) {
            std::memcpy(&value, from, side);
        } else {
            std::memcpy(&value, from, static_cast<std::size_t>(width - tile * side));
        }
        return value;
    }

    void store(const AVFrame& picture, int tile, int j, Row value) const {
        std::uint8_t* const to = row(picture, j) + std::ptrdiff_t{tile} * side;
        if (width - tile * side >= side) {
            std::memcpy(to, &value, side);
        } else {
            std::memcpy(to, &value, static_cast<std::size_t>(width - tile * side));
        }
    }
};

template <class Visit>
void for_each_strip(const AVFrame& picture, const Visit& visit) {
    const auto format = static_cast<AVPixelFormat>(picture.format);
    const int planes = av_pix_fmt_count_planes(format);
    for (int plane = 0; plane < planes; ++plane) {
        const int width = av_image_get_linesize(format, picture.width, plane);
        const bool chroma = plane == 1 || plane == 2;
        const int height =
            chroma ? AV_CEIL_RSHIFT(picture.height, av_pix_fmt_desc_get(format)->log2_chroma_h) : picture.height;
        for (int y = 0; y < height; y += side) visit(Strip{plane, y, width, std::min(side, height - y)});
    }
}

/// The number of its width for each tile of a strip.
class Chooser {
  public:
    std::span<const std::uint8_t> operator()(const Strip& strip, const AVFrame& before, const AVFrame& now) {
        const auto bytes = static_cast<std::size_t>(strip.tiles()) * side;
        for (std::vector<std::uint8_t>& bits : exceeding_) bits.assign(bytes, 0);
        for (int j = 0; j < strip.height; ++j) gather(strip.row(before, j), strip.row(now, j), strip.width);
        chosen_.resize(static_cast<std::size_t>(strip.tiles()));
        for (std::size_t tile = 0; tile < chosen_.size(); ++tile) {
            // What is too large for a width is too large for all that are smaller.
            int number = 0;
            for (const std::vector<std::uint8_t>& bits : exceeding_) {
                Row row = 0;
                std::memcpy(&row, bits.data() + tile * side, side);
                number += row != 0 ? 1 : 0;
            }
            chosen_[tile] = static_cast<std::uint8_t>(number);
        }
        return chosen_;
    }

  private:
    // Along the whole row: that the compiler makes vectors of.
    void gather(const std::uint8_t* before, const std::uint8_t* now, int width) {
        std::uint8_t* const none = exceeding_[0].data();
        std::uint8_t* const two = exceeding_[1].data();
        std::uint8_t* const four = exceeding_[2].data();
        for (int i = 0; i < width; ++i) {
            const auto difference = static_cast<std::uint8_t>(now[i] - before[i]);
            none[i] |= difference;
            two[i] |= static_cast<std::uint8_t>((difference + widths[1].bias) & 0xfc);
            four[i] |= static_cast<std::uint8_t>((difference + widths[2].bias) & 0xf0);
        }
    }

    std::array<std::vector<std::uint8_t>, widths.size() - 1> exceeding_;  ///< not 0 where a width is too small
    std::vector<std::uint8_t> chosen_;
};

constexpr std::size_t per_byte = 4;  // numbers of widths

std::size_t table_bytes(const AVFrame& picture) {
    std::size_t tiles = 0;
    for_each_strip(picture, [&](const Strip& strip) { tiles += static_cast<std::size_t>(strip.tiles()); });
    return (tiles + per_byte - 1) / per_byte;
}

std::size_t picture_bytes(const AVFrame& picture) {
    return static_cast<std::size_t>(
        av_image_get_buffer_size(static_cast<AVPixelFormat>(picture.format), picture.width, picture.height, side));
}

bool alike(const AVFrame& a, const AVFrame& b) {
    return a.width == b.width && a.height == b.height && a.format == b.format && a.color_range == b.color_range &&
           a.colorspace == b.colorspace;
}

Error no_memory() {
    return {ErrorKind::limit, "out of memory for pictures that are kept"};
}

/// Room for a picture that is alike.
AvFrame like(const AVFrame& picture) {
    AvFrame made = av::make_frame();
    made->width = picture.width;
    made->height = picture.height;
    made->format = picture.format;
    made->color_range = picture.color_range;
    made->colorspace = picture.colorspace;
    if (av_frame_get_buffer(made.get(), 0) < 0) throw no_memory();
    return made;
}

void clear(const AVFrame& picture) {
    for_each_strip(picture, [&](const Strip& strip) {
        for (int j = 0; j < strip.height; ++j) std::fill_n(strip.row(picture, j), strip.width, std::uint8_t{0});
    });
}

}  // namespace

void FrameStore::Unmap::operator()(std::uint8_t* memory) const {
    ::munmap(memory, bytes);
}

// Of its own, not of the heap: what is given back there between other things stays with the program.
void FrameStore::make_room(std::size_t bytes) {
    if (!blocks_.empty() && blocks_.back().memory.get_deleter().bytes - blocks_.back().written >= bytes) return;
    constexpr std::size_t block = 4U << 20U;
    const std::size_t size = std::max(bytes, block);
    void* const memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw no_memory();
    blocks_.push_back({{static_cast<std::uint8_t*>(memory), Unmap{size}}});
}

std::size_t FrameStore::bytes() const {
    std::size_t bytes = 0;
    for (const Block& block : blocks_) bytes += block.written;
    return bytes;
}

bool FrameStore::push(const AVFrame& picture) {
    if (pushed_ && !alike(*pushed_, picture)) return false;
    if (!pushed_) {
        pushed_ = like(picture);
        clear(*pushed_);
    }
    const std::size_t table_length = table_bytes(picture);
    make_room(table_length + picture_bytes(picture));
    Block& block = blocks_.back();
    std::uint8_t* const table = block.memory.get() + block.written;  // zero, as memory comes
    std::uint8_t* to = table + table_length;
    std::size_t number = 0;
    Chooser choose;
    for_each_strip(picture, [&](const Strip& strip) {
        const std::span<const std::uint8_t> chosen = choose(strip, *pushed_, picture);
        for (int tile = 0; tile < strip.tiles(); ++tile) {
            const unsigned which = chosen[static_cast<std::size_t>(tile)];
            const std::size_t place = number++;
            if (which == 0) continue;
            table[place / per_byte] |= static_cast<std::uint8_t>(which << 2 * (place % per_byte));
            with_width(which, [&](auto known) {
                constexpr Width width = widths[known];
                for (int j = 0; j < strip.height; ++j) {
                    const Row now = strip.load(picture, tile, j);
                    const Row difference = subtract(now, strip.load(*pushed_, tile, j));
                    strip.store(*pushed_, tile, j, now);
                    to = put<width.bits>(pack<width.bits>(add(difference, each(width.bias))), to);
                }
            });
        }
    });
    block.written = static_cast<std::size_t>(to - block.memory.get());
    ++pictures_;
    return true;
}

AvFrame FrameStore::pop() {
    if (pictures_ == 0) {
        blocks_.clear();
        return nullptr;
    }
    if (blocks_.front().read == blocks_.front().written) blocks_.pop_front();
    Block& block = blocks_.front();
    AvFrame picture = like(*pushed_);
    if (!popped_) clear(*picture);
    const std::uint8_t* const table = block.memory.get() + block.read;
    const std::uint8_t* from = table + table_bytes(*picture);
    std::size_t number = 0;
    for_each_strip(*picture, [&](const Strip& strip) {
        for (int j = 0; popped_ && j < strip.height; ++j) {
            std::copy_n(strip.row(*popped_, j), strip.width, strip.row(*picture, j));
        }
        for (int tile = 0; tile < strip.tiles(); ++tile) {
            const std::size_t place = number++;
            const unsigned which = table[place / per_byte] >> 2 * (place % per_byte) & 3U;
            if (which == 0) continue;
            with_width(which, [&](auto known) {
                constexpr Width width = widths[known];
                for (int j = 0; j < strip.height; ++j) {
                    const Row difference = subtract(unpack<width.bits>(get<width.bits>(from)), each(width.bias));
                    strip.store(*picture, tile, j, add(strip.load(*picture, tile, j), difference));
                }
            });
        }
    });
    block.read = static_cast<std::size_t>(from - block.memory.get());
    --pictures_;
    popped_.reset(av_frame_clone(picture.get()));
    if (!popped_) throw no_memory();
    return picture;
}

}  // namespace vvr
