#include "core/base/file.h"

#include <cerrno>

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/error.h"

namespace vvr {

Descriptor::~Descriptor() {
    if (file_ >= 0) ::close(file_);
}

int open_no_follow(const std::filesystem::path& path, int flags) {
    const int file = ::open(path.c_str(), flags | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
    if (file < 0) return -1;
    struct stat status {};
    if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode)) return file;
    ::close(file);
    errno = EINVAL;
    return -1;
}

int lock_file(int file, bool wait) {
    int result = 0;
    do result = ::flock(file, wait ? LOCK_EX : LOCK_EX | LOCK_NB);
    while (result != 0 && errno == EINTR);
    return result == 0 ? 0 : errno;
}

bool is_same_file(int file, const std::filesystem::path& path, bool follow) {
    struct stat ours {
    }, there{};
    return ::fstat(file, &ours) == 0 &&
           ::fstatat(AT_FDCWD, path.c_str(), &there, follow ? 0 : AT_SYMLINK_NOFOLLOW) == 0 &&
           ours.st_ino == there.st_ino && ours.st_dev == there.st_dev;
}

namespace {

bool is_descriptor_path(const std::string& path) {
    return path.starts_with("/dev/fd/") || path.starts_with("/proc/self/fd/");
}

[[noreturn]] void refuse(const std::string& path, const char* what, int error) {
    throw system_error(error, fmt::format("cannot {} '{}'", what, path), "check its name and permissions");
}

[[noreturn]] void refuse_strange(const std::string& path) {
    throw Error(ErrorCode::not_a_file,
                fmt::format("cannot read '{}': it is a device or a pipe; give a regular file", path));
}

[[noreturn]] void refuse_length(const std::string& path, std::uintmax_t most) {
    throw Error(
        ErrorCode::file_too_large,
        fmt::format(
            "cannot read '{}': it is larger than {} MB, the limit for such files; check that it is the right file",
            path, most >> 20U));
}

}  // namespace

void check_is_file(const std::string& path, std::uintmax_t most) {
    std::error_code none;
    const auto type = std::filesystem::status(path, none).type();
    const bool is_strange = type == std::filesystem::file_type::character ||
                            type == std::filesystem::file_type::block || type == std::filesystem::file_type::socket ||
                            type == std::filesystem::file_type::fifo;
    if (is_strange && !(type == std::filesystem::file_type::fifo && is_descriptor_path(path))) refuse_strange(path);
    const std::uintmax_t length = std::filesystem::file_size(path, none);
    if (!none && length > most) refuse_length(path, most);
}

std::string read_file(const std::string& path, std::uintmax_t most) {
    check_is_file(path);
    // O_NONBLOCK: if the file has become a FIFO since it was checked, don't wait for a writer.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (file.get() < 0 || ::fstat(file.get(), &status) != 0) refuse(path, "open", errno);
    if (S_ISDIR(status.st_mode)) refuse(path, "open", EISDIR);
    const bool piped = S_ISFIFO(status.st_mode) && is_descriptor_path(path);
    if (!S_ISREG(status.st_mode) && !piped) refuse_strange(path);
    if (piped) ::fcntl(file.get(), F_SETFL, 0);  // wait for the writer
    if (S_ISREG(status.st_mode) && static_cast<std::uintmax_t>(status.st_size) > most) refuse_length(path, most);
    std::string bytes;
    constexpr std::size_t piece = 1U << 20U;
    // One byte more than the reported size detects the end.
    std::size_t room = std::max<std::size_t>(static_cast<std::size_t>(status.st_size) + 1, 4096);
    for (std::size_t filled = 0;;) {
        bytes.resize(filled + room);
        const ssize_t got = ::read(file.get(), bytes.data() + filled, room);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) refuse(path, "read", errno);
        filled += static_cast<std::size_t>(got);
        if (filled > most) refuse_length(path, most);
        if (got == 0) {
            bytes.resize(filled);
            return bytes;
        }
        room = piece;
    }
}

std::optional<double> modified_at(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return static_cast<double>(status.st_mtim.tv_sec) + static_cast<double>(status.st_mtim.tv_nsec) * 1e-9;
}

void write_standard_output(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
        if (written >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        } else if (errno == EPIPE) {
            return;
        } else if (errno == EAGAIN) {
            // Another program that shares it has made it non-blocking.
            pollfd ready{STDOUT_FILENO, POLLOUT, 0};
            ::poll(&ready, 1, -1);
        } else if (errno != EINTR) {
            throw system_error(errno, "cannot write to stdout", "check where the output goes");
        }
    }
}

}  // namespace vvr
