#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace vvr {

/// 64-bit FNV-1a hash, the same on every machine and in every version: for work distribution and short names. Not
/// cryptographic.
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

/// The SHA-256 of a whole file, as `sha256sum` prints it.
/// \throws Error io if it can't be read
std::string hex_sha256_of_file(const std::filesystem::path& path);

/// Identifies a file independently of its name.
struct FileDigest {
    std::int64_t bytes = 0;  ///< file size
    std::string ends{};      ///< hex SHA-256 of the first and last 64 KiB, or of the whole file if it is shorter

    friend bool operator==(const FileDigest&, const FileDigest&) = default;
};

/// Hashes only the ends of a file, because hours of footage are too much to read. Clips differ there: in their first
/// key frame, last frames and index.
/// \returns nothing for files that aren't regular or can't be read
std::optional<FileDigest> digest_of(const std::string& path);

}  // namespace vvr
