#include "core/read_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"

namespace vvr {

void check_is_file(const std::string& path) {
    std::error_code none;
    const auto type = std::filesystem::status(path, none).type();
    const bool of_a_shell = type == std::filesystem::file_type::fifo && path.starts_with("/dev/fd/");
    const bool is_strange = type == std::filesystem::file_type::character ||
                            type == std::filesystem::file_type::block || type == std::filesystem::file_type::socket ||
                            type == std::filesystem::file_type::fifo;
    if (!is_strange || of_a_shell) return;
    throw Error(ErrorKind::io, fmt::format("'{}' is no file but a device or a pipe; give a file", path));
}

std::string read_file(const std::string& path) {
    check_is_file(path);
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
