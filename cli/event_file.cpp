#include "cli/event_file.h"

#include <algorithm>
#include <cerrno>
#include <string>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <climits>
#include <fmt/format.h>

#include "cli/log.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"

namespace vvr::cli {

namespace {

namespace fs = std::filesystem;

constexpr int patience = 1000;  // milliseconds for which a reader may be busy: pictures must not wait for it for long

std::string name_of(const fs::path& path) {
    return is_standard_output(path) ? "standard output" : fmt::format("'{}'", path.string());
}

/// Opens a file at its end. A named pipe is opened for reading too, so that this never waits for a reader, and a reader
/// may go and come.
int open_at_end(const fs::path& path) {
    struct stat status {};
    const bool is_pipe = ::stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
    constexpr mode_t mode = 0666;
    return is_pipe ? ::open(path.c_str(), O_RDWR | O_CLOEXEC)
                   : ::open(path.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, mode);
}

/// What is wrong with an existing file, to which nothing must be appended; empty = nothing.
/// \param is_open_line out: whether its last line has no end
std::string fault_of(int file, const struct stat& status, bool& is_open_line) {
    if (S_ISFIFO(status.st_mode)) return {};
    if (!S_ISREG(status.st_mode)) return "it is neither a file nor a named pipe";
    char byte = 0;
    if (status.st_size == 0) return {};
    if (::pread(file, &byte, 1, 0) != 1 || byte != '{') return "it exists, and is no file of events";
    is_open_line = ::pread(file, &byte, 1, status.st_size - 1) == 1 && byte != '\n';
    return {};
}

}  // namespace

EventFile::EventFile(fs::path path, spdlog::logger& log) : path_(std::move(path)), log_(log) {
    if (path_.empty()) return;
    if (is_standard_output(path_)) {
        file_ = STDOUT_FILENO;
        return;
    }
    file_ = open_at_end(path_);
    if (file_ < 0) {
        throw system_error(errno, fmt::format("cannot write events to {}", name_of(path_)),
                           "check its folder and permissions");
    }
    struct stat status {};
    ::fstat(file_, &status);
    is_file_ = S_ISREG(status.st_mode);
    const std::string fault = fault_of(file_, status, is_open_line_);
    if (fault.empty()) return;
    ::close(file_);
    throw Error(ErrorCode::file_invalid,
                fmt::format("cannot write events to {}: {}; use another name", name_of(path_), fault));
}

EventFile::~EventFile() {
    if (file_ > STDOUT_FILENO) ::close(file_);
}

/// As for logs: after logrotate has moved the file, lines go to a new one.
void EventFile::reopen_moved_file() {
    if (!is_file_ || (file_ >= 0 && is_same_file(file_, path_))) return;
    if (file_ >= 0) ::close(file_);
    file_ = open_at_end(path_);
    is_open_line_ = false;
    struct stat status {};
    if (file_ < 0 || ::fstat(file_, &status) != 0 || fault_of(file_, status, is_open_line_).empty()) return;
    ::close(file_);
    file_ = -1;
    errno = EEXIST;  // another program's file has taken the name
}

/// \returns 0, or the error as in errno
int EventFile::write_text(std::string_view text) {
    while (!text.empty()) {
        pollfd wait{file_, POLLOUT, 0};
        const int ready = ::poll(&wait, 1, patience);
        if (ready < 0 && errno == EINTR) continue;
        if (ready == 0) return ETIMEDOUT;
        // A pipe that is ready takes so many bytes at once.
        const ssize_t written = ::write(file_, text.data(), std::min<std::size_t>(text.size(), PIPE_BUF));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        text.remove_prefix(static_cast<std::size_t>(written));
        is_open_line_ = true;
    }
    is_open_line_ = false;
    return 0;
}

void EventFile::add(const events::EventLine& line) {
    if (path_.empty()) return;
    reopen_moved_file();
    const std::string text = events::format_event_line(line);
    const int error = file_ < 0 ? errno : write_text(is_open_line_ ? "\n" + text : text);
    if (error == 0) return;
    error_ = error;
    if (++lost_ > 1) return;
    log_.warn("cannot write an event to {}: {}; it is lost, and pictures go on", name_of(path_),
              error == ETIMEDOUT ? "its reader takes nothing" : text_of_system_error(error));
}

bool EventFile::finish() {
    if (lost_ == 0) return true;
    log_error(log_, code_of_system_error(error_),
              fmt::format("{} could not be written to {}; the pictures are complete",
                          counted(static_cast<std::int64_t>(lost_), "event"), name_of(path_)));
    return false;
}

}  // namespace vvr::cli
