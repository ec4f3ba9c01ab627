#include "core/video/frame_store.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>
#include <utility>

namespace vvr {
namespace {

/// Bytes that are compared at once. A mask of eight bits says in which eighths of them something has changed; behind it
/// comes each of those with a mask of its own, down to single bytes.
constexpr std::size_t block_size = 512;
constexpr std::size_t parts = 8;

/// What the changes of a picture take where all of it has changed, and a byte more.
std::size_t most_bytes(std::size_t bytes) {
    return bytes + bytes / (parts - 1) + 2;
}

/// \returns the end of what was written; the byte there is written too
template <std::size_t size>
std::uint8_t* write_changes(const std::uint8_t* now, const std::uint8_t* before, std::uint8_t* to) {
    constexpr std::size_t part = size / parts;
    std::uint8_t* const mask = to++;
    unsigned changed = 0;
    for (std::size_t i = 0; i < parts; ++i, now += part, before += part) {
        const unsigned differs = std::memcmp(now, before, part) != 0 ? 1 : 0;
        changed |= differs << i;
        if constexpr (part == 1) {
            *to = *now;
            to += differs;  // without a branch: noise can't be predicted
        } else if (differs != 0) {
            to = write_changes<part>(now, before, to);
        }
    }
    *mask = static_cast<std::uint8_t>(changed);
    return to;
}

/// Makes what was `before` into what was `now`.
/// \returns the end of what was read
template <std::size_t size>
const std::uint8_t* read_changes(const std::uint8_t* from, std::uint8_t* here) {
    constexpr std::size_t part = size / parts;
    for (unsigned changed = *from++; changed != 0; changed &= changed - 1) {
        std::uint8_t* const changing = here + static_cast<std::size_t>(std::countr_zero(changed)) * part;
        if constexpr (part == 1) {
            *changing = *from++;
        } else {
            from = read_changes<part>(from, changing);
        }
    }
    return from;
}

/// What is left of a picture after its last whole block comes as it is.
std::uint8_t* write_changes(std::span<const std::uint8_t> now, const std::uint8_t* before, std::uint8_t* to) {
    for (; now.size() >= block_size; now = now.subspan(block_size), before += block_size) {
        to = write_changes<block_size>(now.data(), before, to);
    }
    return std::ranges::copy(now, to).out;
}

const std::uint8_t* read_changes(const std::uint8_t* from, std::span<std::uint8_t> picture) {
    for (; picture.size() >= block_size; picture = picture.subspan(block_size)) {
        from = read_changes<block_size>(from, picture.data());
    }
    std::copy_n(from, picture.size(), picture.begin());
    return from + picture.size();
}

ScaledPicture blank_like(const ScaledPicture& picture) {
    return {Plane<std::uint8_t>(picture.planes.size()), picture.matrix};
}

}  // namespace

FrameStore::Block& FrameStore::block_for(std::size_t bytes) {
    if (blocks_.empty() || blocks_.back().size - blocks_.back().written < bytes) {
        constexpr std::size_t least = 4U << 20U;
        const std::size_t size = std::max(bytes, least);
        blocks_.push_back({std::make_unique_for_overwrite<std::uint8_t[]>(size), size});
    }
    return blocks_.back();
}

bool FrameStore::push(ScaledPicture picture) {
    if (!pushed_) pushed_ = blank_like(picture);
    if (pushed_->planes.size() != picture.planes.size() || pushed_->matrix != picture.matrix) return false;
    const std::span<const std::uint8_t> now = picture.planes.pixels();
    Block& block = block_for(most_bytes(now.size()));
    std::uint8_t* const to = block.memory.get() + block.written;
    const auto written = static_cast<std::size_t>(write_changes(now, pushed_->planes.pixels().data(), to) - to);
    block.written += written;
    bytes_ += written;
    ++pictures_;
    pushed_ = std::move(picture);
    return true;
}

std::optional<ScaledPicture> FrameStore::pop() {
    if (pictures_ == 0) return {};
    if (!popped_) popped_ = blank_like(*pushed_);
    if (blocks_.front().read == blocks_.front().written) blocks_.pop_front();
    Block& block = blocks_.front();
    const std::uint8_t* const from = block.memory.get() + block.read;
    const auto read = static_cast<std::size_t>(read_changes(from, popped_->planes.pixels()) - from);
    block.read += read;
    bytes_ -= read;
    if (--pictures_ == 0) blocks_.clear();
    return popped_;
}

}  // namespace vvr
