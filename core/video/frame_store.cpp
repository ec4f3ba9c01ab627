#include "core/video/frame_store.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <lz4.h>

namespace vvr::video {
namespace {

using Bytes = Plane<std::uint8_t>;

/// \param to memory for the result, larger than it
/// \returns the compressed bytes, a part of `to`
std::span<const char> compress(const Bytes& from, std::vector<char>& to) {
    const int length = static_cast<int>(from.pixels().size());
    to.resize(static_cast<std::size_t>(LZ4_compressBound(length)));
    constexpr int acceleration = 16;
    const int written = LZ4_compress_fast(reinterpret_cast<const char*>(from.pixels().data()), to.data(), length,
                                          static_cast<int>(to.size()), acceleration);
    return std::span(to).first(static_cast<std::size_t>(written));
}

Bytes decompressed(std::span<const char> from, Size size) {
    auto bytes = Bytes::for_overwrite(size);
    LZ4_decompress_safe(from.data(), reinterpret_cast<char*>(bytes.pixels().data()), static_cast<int>(from.size()),
                        static_cast<int>(bytes.pixels().size()));
    return bytes;
}

/// `here` becomes how `other` differs from it, modulo 256.
void difference(Bytes& here, const Bytes& other) {
    std::uint8_t* const to = here.pixels().data();
    const std::uint8_t* const from = other.pixels().data();
    const std::size_t count = here.pixels().size();
    for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<std::uint8_t>(from[i] - to[i]);
}

/// Undoes `difference`: adds the change, modulo 256.
void add(const Bytes& change, Bytes& here) {
    std::uint8_t* const to = here.pixels().data();
    const std::uint8_t* const by = change.pixels().data();
    const std::size_t count = here.pixels().size();
    for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<std::uint8_t>(to[i] + by[i]);
}

}  // namespace

bool FrameStore::push(ScaledPicture picture) {
    if (!pushed_) pushed_ = {Bytes(picture.planes.size()), picture.matrix};
    Bytes& before = pushed_->planes;
    if (before.size() != picture.planes.size() || pushed_->matrix != picture.matrix) return false;
    difference(before, picture.planes);
    const auto packed = compress(before, scratch_);
    packed_.emplace_back(packed.begin(), packed.end());
    bytes_ += packed.size();
    pushed_ = std::move(picture);
    return true;
}

std::optional<ScaledPicture> FrameStore::pop() {
    if (packed_.empty()) return {};
    const Bytes change = decompressed(packed_.front(), pushed_->planes.size());
    bytes_ -= packed_.front().size();
    packed_.pop_front();
    if (!popped_) popped_ = {Bytes(change.size()), pushed_->matrix};
    add(change, popped_->planes);
    return popped_;
}

}  // namespace vvr::video
