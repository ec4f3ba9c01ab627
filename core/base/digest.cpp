#include "core/base/digest.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <system_error>

#include <fmt/format.h>

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

std::string hex_sha256(std::string_view bytes) {
    std::string text;
    for (const std::byte byte : sha256(bytes)) text += fmt::format("{:02x}", std::to_integer<int>(byte));
    return text;
}

std::optional<FileDigest> digest_of(const std::string& path) {
    constexpr std::uintmax_t end = 64 * 1024;
    std::error_code none;
    if (!std::filesystem::is_regular_file(path, none)) return std::nullopt;
    const std::uintmax_t size = std::filesystem::file_size(path, none);
    std::ifstream file(path, std::ios::binary);
    if (none || !file) return std::nullopt;
    std::string read(std::min(size, 2 * end), '\0');
    const auto first = static_cast<std::streamsize>(std::min<std::uintmax_t>(read.size(), end));
    const auto last = static_cast<std::streamsize>(read.size()) - first;
    file.read(read.data(), first);
    file.seekg(-last, std::ios::end);
    if (last > 0) file.read(std::next(read.data(), first), last);
    if (!file) return std::nullopt;
    return FileDigest{static_cast<std::int64_t>(size), hex_sha256(read)};
}

}  // namespace vvr
