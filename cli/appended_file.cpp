#include "cli/appended_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <climits>
#include <fmt/format.h>

#include "core/base/error.h"

namespace vvr::cli {

namespace {

/// Whether a text begins so, or would: a full disk may have cut its only line short.
bool begins_as(std::string_view text, std::string_view beginning) {
    const std::size_t both = std::min(text.size(), beginning.size());
    return std::ranges::equal(text.substr(0, both), beginning.substr(0, both), [](char found, char expected) {
        return expected == '0' ? found >= '0' && found <= '9' : found == expected;
    });
}

}  // namespace

AppendedFile::AppendedFile(std::filesystem::path path, const AppendedKind& kind) : path_(std::move(path)), kind_(kind) {
    if (kind_.streams && is_standard_output(path_)) return;
    const std::string failed = fmt::format("cannot write {} '{}'", kind_.what, path_.string());
    std::string_view fault;
    if (const int error = open(fault); error != 0)
        throw system_error(error, failed, "check its folder and permissions");
    if (!fault.empty()) throw Error(ErrorCode::file_invalid, fmt::format("{}: {}; use another name", failed, fault));
}

/// Opens the file at its end.
/// \param fault out: what is wrong with an existing file; empty = nothing
/// \returns 0, or the error as in errno
int AppendedFile::open(std::string_view& fault) {
    // For reading too: so a named pipe needs no reader, and a reader may go and come. Nothing waits for it here.
    constexpr int flags = O_RDWR | O_APPEND | O_NONBLOCK | O_CLOEXEC;
    constexpr mode_t mode = 0666;
    Descriptor file(::open(path_.c_str(), flags));
    // Not at once with O_CREAT, which the kernel refuses for another user's pipe in /tmp.
    if (file.get() < 0 && errno == ENOENT) file = Descriptor(::open(path_.c_str(), flags | O_CREAT, mode));
    struct stat status {};
    if (file.get() < 0 || ::fstat(file.get(), &status) != 0) return errno;
    const bool is_file = S_ISREG(status.st_mode);
    bool is_open_line = false;
    if (is_file && status.st_size > 0) {
        std::array<char, 64> begin{};
        const ssize_t bytes = ::pread(file.get(), begin.data(), begin.size(), 0);
        const std::string_view text(begin.data(), static_cast<std::size_t>(std::max<ssize_t>(bytes, 0)));
        if (std::ranges::none_of(kind_.beginnings, [&](std::string_view known) { return begins_as(text, known); }))
            fault = "it exists, and does not begin as one that vvr wrote";
        char last = 0;
        is_open_line = ::pread(file.get(), &last, 1, status.st_size - 1) == 1 && last != '\n';
    } else if (!is_file && !kind_.streams) {
        fault = "it is not a regular file";
    } else if (!is_file && !S_ISFIFO(status.st_mode)) {
        fault = "it is neither a file nor a named pipe";
    }
    if (!fault.empty()) return 0;
    opened_ = std::move(file);
    is_file_ = is_file;
    is_open_line_ = is_open_line;
    return 0;
}

/// \returns 0, or the error as in errno
int AppendedFile::write(std::string_view text) {
    constexpr int patience = 1000;  // milliseconds: pictures must not wait for a reader for long
    const int file = opened_.get() < 0 ? STDOUT_FILENO : opened_.get();
    // A pipe that is ready takes so many bytes at once. A file takes a whole line, so that those of several programs
    // don't mix.
    const std::size_t most = is_file_ ? text.size() : PIPE_BUF;
    while (!text.empty()) {
        pollfd wait{file, POLLOUT, 0};
        const int ready = ::poll(&wait, 1, patience);
        if (ready < 0 && errno == EINTR) continue;
        if (ready == 0) return ETIMEDOUT;
        const ssize_t written = ::write(file, text.data(), std::min(text.size(), most));
        if (written < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (written < 0) return errno;
        text.remove_prefix(static_cast<std::size_t>(written));
        is_open_line_ = true;
    }
    is_open_line_ = false;
    return 0;
}

int AppendedFile::append(std::string_view line) {
    if (is_file_ && !is_same_file(opened_.get(), path_, true)) {
        std::string_view fault;
        if (const int error = open(fault); error != 0) return error;
        if (!fault.empty()) return EEXIST;  // another program's file has taken the name
    }
    return is_open_line_ ? write("\n" + std::string(line)) : write(line);
}

}  // namespace vvr::cli
