#include "core/media/input.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/media/settings.h"

extern "C" {
#include <libavformat/avformat.h>
}

namespace vvr::media {

namespace {

constexpr std::string_view file_protocol = "file:";

std::shared_ptr<const Descriptor> open_descriptor(const std::string& path) {
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd < 0) {
        const int why = errno;
        throw system_error(why, fmt::format("cannot read '{}'", path),
                           why == EMFILE   ? "raise the limit of open files (`ulimit -n`)"
                           : why == EACCES ? "check its permissions and those of its folder"
                                           : "check its name");
    }
    return std::make_shared<Descriptor>(fd);
}

struct stat status_of(const Descriptor& file, const std::string& name) {
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) throw system_error(errno, fmt::format("cannot read '{}'", name));
    return status;
}

void require_bytes(const Descriptor& file, const std::string& name) {
    if (status_of(file, name).st_size == 0) {
        throw Error(ErrorCode::file_empty,
                    fmt::format("'{}' is empty (0 bytes); check the program that writes it", name));
    }
}

std::string folder() {
    const char* asked = std::getenv("TMPDIR");
    return asked && *asked ? asked : "/var/tmp";
}

Error spool_error(const std::string& name, const std::string& where, std::int64_t bytes, int why) {
    const std::string next = why == ENOSPC || why == EDQUOT || why == EFBIG
                                 ? "set TMPDIR to a folder with more space, or give a file"
                                 : "set TMPDIR to a writable folder, or give a file";
    return system_error(why,
                        fmt::format("cannot store the stream '{}' in {} after {:.1f} MB", name, where,
                                    static_cast<double>(bytes) / 1e6),
                        next);
}

std::shared_ptr<const Descriptor> make_unlinked(const std::string& name, const std::string& where) {
    std::string path = where + "/vvr-XXXXXX";
    const int fd = ::mkostemp(path.data(), O_CLOEXEC);
    if (fd < 0) throw spool_error(name, where, 0, errno);
    auto file = std::make_shared<Descriptor>(fd);
    if (::unlink(path.c_str()) != 0) throw spool_error(name, where, 0, errno);
    return file;
}

/// Returns 0, or the errno of the write that failed.
int write_all(int fd, std::span<const char> bytes) {
    while (!bytes.empty()) {
        const auto put = ::write(fd, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) return errno;
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
    return 0;
}

/// Copies all bytes of `from` to an unlinked temporary file in $TMPDIR or /var/tmp. The kernel removes the file with
/// its last descriptor, even if the program crashes.
///
/// \param name name of the stream, for messages
/// \throws Error io if reading or writing fails, also if the disk is full
std::shared_ptr<const Descriptor> spool(const Descriptor& from, const std::string& name) {
    const std::string where = folder();
    auto file = make_unlinked(name, where);
    std::vector<char> buffer(1 << 20);
    std::int64_t total = 0;
    for (;;) {
        const auto got = ::read(from.get(), buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) {
            throw system_error(errno,
                               fmt::format("cannot read '{}' after {:.1f} MB", name, static_cast<double>(total) / 1e6));
        }
        if (got == 0) return file;
        if (const int why = write_all(file->get(), std::span(buffer).first(static_cast<std::size_t>(got)))) {
            throw spool_error(name, where, total, why);
        }
        total += got;
    }
}

void require_redirected_stdin() {
    if (!::isatty(STDIN_FILENO)) return;
    throw Error(ErrorCode::input_unsuitable, "cannot read '-': stdin is a terminal; pipe or redirect a video into it");
}

Input open_stdin() {
    require_redirected_stdin();
    const int fd = ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0);
    if (fd < 0) throw system_error(errno, "cannot read stdin");
    Input input{"-", {}, std::make_shared<Descriptor>(fd)};
    if (!S_ISREG(status_of(*input.file, "-").st_mode)) input.file = spool(*input.file, "-");
    require_bytes(*input.file, "-");
    return input;
}

}  // namespace

bool is_url(const std::string& name) {
    const auto colon = name.find("://");
    return colon != std::string::npos && colon > 0 &&
           std::all_of(name.begin(), name.begin() + static_cast<long>(colon), [](char c) {
               return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' || c == '.';
           });
}

bool is_local(const Input& input) {
    return input.file || input.url.starts_with(file_protocol);
}

Input open_input(const std::string& name) {
    if (name == "-") return open_stdin();
    if (is_url(name) && ::access(name.c_str(), F_OK) != 0) return {redact_secrets(name), name, nullptr};

    const auto file = open_descriptor(name);
    const auto mode = status_of(*file, name).st_mode;
    if (S_ISREG(mode)) {
        require_bytes(*file, name);
        // libav opens it by name. With the prefix, it doesn't parse a name such as "cam:1.avi" as a protocol. Leading
        // slashes are reduced to one, because "file://" begins a URL.
        const auto slashes = std::min(name.find_first_not_of('/'), name.size());
        return {name, std::string(file_protocol) + name.substr(slashes > 1 ? slashes - 1 : 0), nullptr};
    }
    if (S_ISCHR(mode) || S_ISBLK(mode)) {
        throw Error(
            ErrorCode::not_a_file,
            fmt::format("'{}' is a device, which may never end; give a file, or read a camera with `vvr watch`", name));
    }
    Input spooled{name, {}, spool(*file, name)};
    require_bytes(*spooled.file, name);
    return spooled;
}

Input open_track(const std::string& name, int track) {
    Input input = open_input(name);
    input.track = track;
    return input;
}

Input open_file(const std::string& path) {
    Input input{path, {}, open_descriptor(path)};
    if (!S_ISREG(status_of(*input.file, path).st_mode)) {
        throw Error(ErrorCode::not_a_file, fmt::format("cannot read '{}': not a regular file; give a file", path));
    }
    return input;
}

FileReader::FileReader(std::shared_ptr<const Descriptor> file)
    : file_(std::move(file)), context_(av::make_reader(this, &FileReader::read, &FileReader::seek)) {}

int FileReader::read(void* self, std::uint8_t* buffer, int size) {
    auto& reader = *static_cast<FileReader*>(self);
    const auto got = ::pread(reader.file_->get(), buffer, static_cast<std::size_t>(size), reader.position_);
    if (got < 0) return AVERROR(errno);
    if (got == 0) return AVERROR_EOF;
    reader.position_ += got;
    return static_cast<int>(got);
}

std::int64_t FileReader::seek(void* self, std::int64_t offset, int whence) {
    auto& reader = *static_cast<FileReader*>(self);
    struct stat status {};
    if (::fstat(reader.file_->get(), &status) != 0) return AVERROR(errno);
    switch (whence & ~AVSEEK_FORCE) {
        case AVSEEK_SIZE:
            return status.st_size;
        case SEEK_SET:
            break;
        case SEEK_CUR:
            offset += reader.position_;
            break;
        case SEEK_END:
            offset += status.st_size;
            break;
        default:
            return AVERROR(EINVAL);
    }
    if (offset < 0) return AVERROR(EINVAL);
    return reader.position_ = offset;
}

PipeReader::PipeReader(std::shared_ptr<const Descriptor> pipe, std::shared_ptr<const Watchdog> watchdog)
    : pipe_(std::move(pipe)), watchdog_(std::move(watchdog)), context_(av::make_reader(this, &PipeReader::read)) {}

int PipeReader::read(void* self, std::uint8_t* buffer, int size) {
    const auto& reader = *static_cast<PipeReader*>(self);
    constexpr int milliseconds = 100;  // between polls of the watchdog
    for (;;) {
        // The writer of a pipe may pause for any time, so there is no timeout; only `stop` ends the wait.
        if (reader.watchdog_->stopped()) return AVERROR_EXIT;
        pollfd waited{reader.pipe_->get(), POLLIN, 0};
        if (::poll(&waited, 1, milliseconds) == 0) continue;
        const auto got = ::read(reader.pipe_->get(), buffer, static_cast<std::size_t>(size));
        if (got > 0) return static_cast<int>(got);
        if (got == 0) return AVERROR_EOF;
        if (errno != EINTR && errno != EAGAIN) return AVERROR(errno);
    }
}

namespace {

// ---- Live inputs

// libavdevice depends on about a hundred libraries for windows and sound, so it is loaded only for a device. Its major
// version equals libavformat's.
void load_devices(const std::string& name) {
    const std::string library = fmt::format("libavdevice.so.{}", LIBAVFORMAT_VERSION_MAJOR);
    void* const loaded = while_loading([&] { return ::dlopen(library.c_str(), RTLD_NOW | RTLD_GLOBAL); });
    void* const found = loaded == nullptr ? nullptr : ::dlsym(loaded, "avdevice_register_all");
    if (found == nullptr) {
        throw Error(
            ErrorCode::usage,
            fmt::format("cannot read the device '{}': cannot load {}: {}; install Debian's libavdevice{}, or pipe the "
                        "camera in: ffmpeg -f v4l2 -i {} -f matroska - | vvr watch -",
                        name, library, ::dlerror(), LIBAVFORMAT_VERSION_MAJOR, name));
    }
    reinterpret_cast<void (*)()>(found)();
}

Input open_pipe(const std::string& name, int fd) {
    if (fd < 0) throw system_error(errno, fmt::format("cannot read '{}'", name), "check its name and permissions");
    return {name, {}, nullptr, std::make_shared<Descriptor>(fd)};
}

/// Opens a named pipe without blocking, and waits for its first bytes until `watchdog` expires.
Input open_named_pipe(const std::string& name, const Watchdog& watchdog) {
    Input input = open_pipe(name, ::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    constexpr int milliseconds = 100;  // between polls of the watchdog
    for (;;) {
        pollfd waited{input.pipe->get(), POLLIN, 0};
        if (::poll(&waited, 1, milliseconds) > 0) return input;
        if (watchdog.expired()) {
            throw Error(
                ErrorCode::stream_timeout,
                fmt::format(
                    "cannot read '{}': no data arrived in the pipe in time; start the program that writes to it", name),
                {setting::patience.name});
        }
    }
}

Input open_any(const std::string& name, const Watchdog& watchdog) {
    if (name == "-") {
        require_redirected_stdin();
        return open_pipe("-", ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0));
    }
    struct stat status {};
    if (::stat(name.c_str(), &status) != 0) {
        const int why = errno;
        if (is_url(name)) return {redact_secrets(name), name, nullptr};
        throw system_error(why, fmt::format("cannot read '{}'", name),
                           "give a URL such as rtsp://camera/stream, a device, a pipe or a file");
    }
    if (S_ISREG(status.st_mode)) return open_input(name);
    if (S_ISDIR(status.st_mode)) {
        throw Error(ErrorCode::input_unsuitable,
                    fmt::format("cannot watch '{}': it is a folder; use `vvr render` for a folder of pictures", name));
    }
    if (S_ISCHR(status.st_mode)) {
        load_devices(name);
        return {name, name, nullptr, nullptr, "video4linux2"};
    }
    return open_named_pipe(name, watchdog);
}

}  // namespace

Input open_live_input(const std::string& name, std::shared_ptr<Watchdog> watchdog) {
    Input input = open_any(name, *watchdog);
    input.watchdog = std::move(watchdog);
    return input;
}

}  // namespace vvr::media
