#include "core/video/frame_store.h"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>

#include <lz4.h>

namespace vvr {
namespace {

using Bytes = Plane<std::uint8_t>;

/// \returns what `to` holds then: the compressed bytes
std::span<const char> compress(const Bytes& from, std::vector<char>& to) {
    const int length = static_cast<int>(from.pixels().size());
    to.resize(static_cast<std::size_t>(LZ4_compressBound(length)));
    constexpr int acceleration = 8;
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

/// Sums or differences of bytes, modulo 256.
template <class Operation>
void combine(Bytes& here, const Bytes& other, const Operation& operation) {
    std::ranges::transform(here.pixels(), other.pixels(), here.pixels().begin(), [&](unsigned a, unsigned b) {
        return static_cast<std::uint8_t>(operation(a, b));
    });
}

}  // namespace

bool FrameStore::push(ScaledPicture picture) {
    if (!pushed_) pushed_ = {Bytes(picture.planes.size()), picture.matrix};
    Bytes& before = pushed_->planes;
    if (before.size() != picture.planes.size() || pushed_->matrix != picture.matrix) return false;
    combine(before, picture.planes, std::minus());
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
    combine(popped_->planes, change, std::minus());
    return popped_;
}

}  // namespace vvr
