#include "core/video/pipe_reader.h"

#include <cerrno>
#include <utility>

#include <poll.h>
#include <unistd.h>

#include "core/video/av.h"

namespace vvr::video {

PipeReader::PipeReader(std::shared_ptr<const Descriptor> pipe, std::shared_ptr<const Watchdog> watchdog)
    : pipe_(std::move(pipe)), watchdog_(std::move(watchdog)), context_(av::make_reader(this, &PipeReader::read)) {}

int PipeReader::read(void* self, std::uint8_t* buffer, int size) {
    const auto& reader = *static_cast<PipeReader*>(self);
    constexpr int milliseconds = 100;  // between two looks at the watchdog
    for (;;) {
        // The writer of a pipe may take its time; only a request to stop ends the wait.
        if (reader.watchdog_->stopped()) return AVERROR_EXIT;
        pollfd waited{reader.pipe_->get(), POLLIN, 0};
        if (::poll(&waited, 1, milliseconds) == 0) continue;
        const auto got = ::read(reader.pipe_->get(), buffer, static_cast<std::size_t>(size));
        if (got > 0) return static_cast<int>(got);
        if (got == 0) return AVERROR_EOF;
        if (errno != EINTR && errno != EAGAIN) return AVERROR(errno);
    }
}

}  // namespace vvr::video
