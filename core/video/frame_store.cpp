#include "core/video/frame_store.h"

#include <algorithm>
#include <span>
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
#include "core/video/tile_changes.h"

namespace vvr {
namespace {

template <class Visit>
void for_each_strip(const AVFrame& picture, const Visit& visit) {
    const auto format = static_cast<AVPixelFormat>(picture.format);
    const int planes = av_pix_fmt_count_planes(format);
    for (int plane = 0; plane < planes; ++plane) {
        const int width = av_image_get_linesize(format, picture.width, plane);
        const bool chroma = plane == 1 || plane == 2;
        const int height =
            chroma ? AV_CEIL_RSHIFT(picture.height, av_pix_fmt_desc_get(format)->log2_chroma_h) : picture.height;
        for (int y = 0; y < height; y += change_side) visit(plane, y, width, std::min(change_side, height - y));
    }
}

template <class Byte>
Strip<Byte> strip_of(const AVFrame& picture, int plane, int y, int width, int height) {
    const std::ptrdiff_t stride = picture.linesize[plane];
    return {picture.data[plane] + y * stride, stride, width, height};
}

constexpr std::size_t per_byte = 4;  // widths

std::size_t count_tiles(const AVFrame& picture) {
    std::size_t tiles = 0;
    for_each_strip(picture, [&](int, int, int width, int) {
        tiles += static_cast<std::size_t>((width + change_side - 1) / change_side);
    });
    return tiles;
}

std::size_t table_bytes(std::size_t tiles) {
    return (tiles + per_byte - 1) / per_byte;
}

void pack_table(std::span<const std::uint8_t> widths, std::uint8_t* table) {
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const unsigned shift = 2 * (i % per_byte);
        table[i / per_byte] = static_cast<std::uint8_t>(table[i / per_byte] | unsigned{widths[i]} << shift);
    }
}

void unpack_table(const std::uint8_t* table, std::span<std::uint8_t> widths) {
    for (std::size_t i = 0; i < widths.size(); ++i) {
        widths[i] = static_cast<std::uint8_t>(table[i / per_byte] >> 2 * (i % per_byte) & 3U);
    }
}

std::size_t picture_bytes(const AVFrame& picture) {
    return static_cast<std::size_t>(av_image_get_buffer_size(static_cast<AVPixelFormat>(picture.format), picture.width,
                                                             picture.height, change_side));
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
    for_each_strip(picture, [&](int plane, int y, int width, int height) {
        const auto strip = strip_of<std::uint8_t>(picture, plane, y, width, height);
        for (int j = 0; j < height; ++j) std::fill_n(strip.row(j), width, std::uint8_t{0});
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
    std::vector<std::uint8_t> widths(count_tiles(picture));
    const std::size_t table_length = table_bytes(widths.size());
    make_room(table_length + picture_bytes(picture));
    Block& block = blocks_.back();
    std::uint8_t* const table = block.memory.get() + block.written;  // zero, as memory comes
    std::uint8_t* to = table + table_length;
    std::span<std::uint8_t> left = widths;
    for_each_strip(picture, [&](int plane, int y, int width, int height) {
        const auto now = strip_of<const std::uint8_t>(picture, plane, y, width, height);
        const auto before = strip_of<std::uint8_t>(*pushed_, plane, y, width, height);
        const auto tiles = static_cast<std::size_t>(now.tiles());
        to = write_changes(now, before, left.first(tiles), to);
        left = left.subspan(tiles);
    });
    pack_table(widths, table);
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
    std::vector<std::uint8_t> widths(count_tiles(*picture));
    const std::uint8_t* const table = block.memory.get() + block.read;
    unpack_table(table, widths);
    const std::uint8_t* from = table + table_bytes(widths.size());
    std::span<const std::uint8_t> left = widths;
    for_each_strip(*picture, [&](int plane, int y, int width, int height) {
        const auto strip = strip_of<std::uint8_t>(*picture, plane, y, width, height);
        for (int j = 0; popped_ && j < height; ++j) {
            std::copy_n(strip_of<const std::uint8_t>(*popped_, plane, y, width, height).row(j), width, strip.row(j));
        }
        const auto tiles = static_cast<std::size_t>(strip.tiles());
        from = read_changes(strip, left.first(tiles), from);
        left = left.subspan(tiles);
    });
    block.read = static_cast<std::size_t>(from - block.memory.get());
    --pictures_;
    popped_.reset(av_frame_clone(picture.get()));
    if (!popped_) throw no_memory();
    return picture;
}

}  // namespace vvr
