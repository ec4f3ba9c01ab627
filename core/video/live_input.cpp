#include <cerrno>
#include <cstring>
#include <utility>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

extern "C" {
#include <libavformat/avformat.h>
}

#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/video/av.h"
#include "core/video/input.h"
#include "core/video/settings.h"

namespace vvr::video {
namespace {

// libavdevice depends on about a hundred libraries for windows and sound, so it is loaded only for a device. Its major
// version equals libavformat's.
void load_devices(const std::string& name) {
    const std::string library = fmt::format("libavdevice.so.{}", LIBAVFORMAT_VERSION_MAJOR);
    void* const loaded = while_loading([&] { return ::dlopen(library.c_str(), RTLD_NOW | RTLD_GLOBAL); });
    void* const found = loaded == nullptr ? nullptr : ::dlsym(loaded, "avdevice_register_all");
    if (found == nullptr) {
        throw Error(
            ErrorCode::usage,
            fmt::format("'{}' is a device, which takes {}, and it is not there: {}; install Debian's "
                        "libavdevice{}, or pipe the camera in: ffmpeg -f v4l2 -i {} -f matroska - | vvr watch -",
                        name, library, ::dlerror(), LIBAVFORMAT_VERSION_MAJOR, name));
    }
    reinterpret_cast<void (*)()>(found)();
}

Input open_pipe(const std::string& name, int fd) {
    if (fd < 0) {
        const int why = errno;
        throw Error(code_of_system_error(why),
                    fmt::format("cannot read '{}': {}; check the name and its permissions", name, std::strerror(why)));
    }
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
                fmt::format("cannot read '{}': nothing came through the pipe in time; start what writes to it", name),
                {setting::patience.name});
        }
    }
}

Input open_any(const std::string& name, const Watchdog& watchdog) {
    if (name == "-") {
        if (::isatty(STDIN_FILENO)) {
            throw Error(ErrorCode::input_unsuitable,
                        "input '-' is stdin, and stdin is a terminal: pipe or redirect a video into it");
        }
        return open_pipe("-", ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0));
    }
    struct stat status {};
    if (::stat(name.c_str(), &status) != 0) {
        const int why = errno;
        if (is_url(name)) return {redact_secrets(name), name, nullptr};
        throw Error(code_of_system_error(why),
                    fmt::format("cannot read '{}': {}; give a URL such as rtsp://camera/stream, a device, a pipe or a "
                                "file",
                                name, std::strerror(why)));
    }
    if (S_ISREG(status.st_mode)) return open_input(name);
    if (S_ISDIR(status.st_mode)) {
        throw Error(ErrorCode::input_unsuitable,
                    fmt::format("'{}' is a folder, not a stream; `vvr render` takes pictures", name));
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

}  // namespace vvr::video
