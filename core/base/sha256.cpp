#include "core/base/sha256.h"

#include <cstdint>
#include <memory>
#include <new>

extern "C" {
#include <libavutil/mem.h>
#include <libavutil/sha.h>
}

namespace vvr {

namespace {

struct AvFree {
    void operator()(AVSHA* sha) const { av_free(sha); }
};

}  // namespace

std::array<std::byte, 32> sha256(std::string_view bytes) {
    const std::unique_ptr<AVSHA, AvFree> sha(av_sha_alloc());
    if (!sha) throw std::bad_alloc();
    std::array<std::byte, 32> digest{};
    av_sha_init(sha.get(), 256);
    av_sha_update(sha.get(), reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    av_sha_final(sha.get(), reinterpret_cast<std::uint8_t*>(digest.data()));
    return digest;
}

}  // namespace vvr
