#include "core/base/digest.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <system_error>

#include <fmt/format.h>

#include "core/base/error.h"

extern "C" {
#include <libavutil/mem.h>
#include <libavutil/sha.h>
}

namespace vvr {

namespace {

using Sha256 = std::array<std::byte, 32>;

/// The SHA-256 of bytes that come in parts.
class Sha256Stream {
  public:
    Sha256Stream() : sha_(av_sha_alloc()) {
        if (!sha_) throw std::bad_alloc();
        av_sha_init(sha_.get(), 256);
    }

    void add(std::string_view bytes) {
        av_sha_update(sha_.get(), reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    }

    /// Call it once.
    Sha256 digest() {
        Sha256 digest{};
        av_sha_final(sha_.get(), reinterpret_cast<std::uint8_t*>(digest.data()));
        return digest;
    }

  private:
    struct AvFree {
        void operator()(AVSHA* sha) const { av_free(sha); }
    };

    std::unique_ptr<AVSHA, AvFree> sha_;
};

std::string hex_of(const Sha256& digest) {
    std::string text;
    for (const std::byte byte : digest) text += fmt::format("{:02x}", std::to_integer<int>(byte));
    return text;
}

}  // namespace

std::array<std::byte, 32> sha256(std::string_view bytes) {
    Sha256Stream sha;
    sha.add(bytes);
    return sha.digest();
}

std::string hex_sha256(std::string_view bytes) {
    return hex_of(sha256(bytes));
}

std::string hex_sha256_of_file(const std::filesystem::path& path) {
    constexpr std::size_t part = std::size_t{1} << 20;
    std::ifstream file(path, std::ios::binary);
    std::string bytes(part, '\0');
    Sha256Stream sha;
    while (file) {
        file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        sha.add(std::string_view(bytes).substr(0, static_cast<std::size_t>(file.gcount())));
    }
    if (!file.eof())
        throw system_error(errno, fmt::format("cannot read '{}'", path.string()), "check its name and permissions");
    return hex_of(sha.digest());
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
