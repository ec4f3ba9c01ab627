#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vvr {

/// FNV-1a of 64 bits: the same number for the same bytes on every machine and in every version, to share out work and
/// to make short names. It keeps no secrets.
constexpr std::uint64_t fnv1a(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : bytes) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3;
    }
    return hash;
}

std::array<std::byte, 32> sha256(std::string_view bytes);

/// In hexadecimal digits.
std::string hex_sha256(std::string_view bytes);

/// What tells a file from others, whatever its name is.
struct FileDigest {
    std::int64_t bytes = 0;  ///< its size
    std::string ends{};      ///< SHA-256 of its first and its last 64 KiB; of all of it where it has no more; hex

    friend bool operator==(const FileDigest&, const FileDigest&) = default;
};

/// Hours of footage are too much to read once more: a key frame at the beginning, the last frames and an index differ
/// from clip to clip.
/// \returns nothing for what is no regular file, or can't be read
std::optional<FileDigest> digest_of(const std::string& path);

}  // namespace vvr
