#include "cli/log_file.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/error.h"

namespace vvr::cli {

namespace {

int open_at_end(const std::string& path) {
    constexpr mode_t mode = 0666;
    return ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, mode);
}

}  // namespace

LogFile::LogFile(std::string path) : path_(std::move(path)), fd_(open_at_end(path_)) {
    if (fd_ >= 0) return;
    throw Error(ErrorKind::io, fmt::format("cannot write the log '{}': {}; check its folder and permissions", path_,
                                           std::strerror(errno)));
}

LogFile::~LogFile() {
    if (fd_ >= 0) ::close(fd_);
}

bool LogFile::is_still_there() const {
    struct stat open {};
    struct stat named {};
    return ::fstat(fd_, &open) == 0 && ::stat(path_.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
           open.st_ino == named.st_ino;
}

// A line that can't be written is lost: no picture is to fail for it.
void LogFile::sink_it_(const spdlog::details::log_msg& message) {
    if (fd_ < 0 || !is_still_there()) {
        if (fd_ >= 0) ::close(fd_);
        fd_ = open_at_end(path_);
    }
    spdlog::memory_buf_t line;
    formatter_->format(message, line);
    [[maybe_unused]] const auto written = fd_ < 0 ? 0 : ::write(fd_, line.data(), line.size());
}

}  // namespace vvr::cli
