#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace vvr {

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
