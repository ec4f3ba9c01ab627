#include "core/base/standard_output.h"

#include <cerrno>
#include <string>
#include <system_error>

#include <unistd.h>

#include "core/base/error.h"

namespace vvr {

void write_standard_output(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
        if (written >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        } else if (errno == EPIPE) {
            return;
        } else if (errno != EINTR) {
            throw Error(ErrorKind::io, "cannot write to stdout: " + std::generic_category().message(errno));
        }
    }
}

}  // namespace vvr
