#include "core/read_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "core/error.h"

namespace vvr {

std::string read_file(const std::string& path) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    // A folder opens, and only reading it fails.
    if (!file || std::filesystem::is_directory(path)) {
        throw Error(ErrorKind::io,
                    fmt::format("{}: can't be opened: {}", path, file ? std::strerror(EISDIR) : std::strerror(errno)));
    }
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (file.bad()) throw Error(ErrorKind::io, fmt::format("{}: can't be read: {}", path, std::strerror(errno)));
    return bytes;
}

}  // namespace vvr
