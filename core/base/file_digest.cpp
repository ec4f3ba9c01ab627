#include "core/base/file_digest.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fmt/format.h>

#include "core/base/sha256.h"

namespace vvr {

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
    FileDigest digest{static_cast<std::int64_t>(size)};
    for (const std::byte byte : sha256(read)) digest.ends += fmt::format("{:02x}", std::to_integer<int>(byte));
    return digest;
}

}  // namespace vvr
