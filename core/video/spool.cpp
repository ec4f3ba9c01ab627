#include "core/video/spool.h"

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/error.h"

namespace vvr::video {
namespace {

std::string folder() {
    const char* asked = std::getenv("TMPDIR");
    return asked && *asked ? asked : "/var/tmp";
}

Error failed(const std::string& name, const std::string& where, std::int64_t bytes, int why) {
    const std::string next = why == ENOSPC || why == EDQUOT || why == EFBIG
                                 ? "set TMPDIR to a folder with more room, or give the video as a file"
                                 : "set TMPDIR to a folder that can be written, or give the video as a file";
    return {ErrorKind::io, fmt::format("cannot keep the stream '{}' in {} after {:.1f} MB: {}; {}", name, where,
                                       static_cast<double>(bytes) / 1e6, std::strerror(why), next)};
}

std::shared_ptr<const Descriptor> make_unlinked(const std::string& name, const std::string& where) {
    std::string path = where + "/vvr-XXXXXX";
    const int fd = ::mkostemp(path.data(), O_CLOEXEC);
    if (fd < 0) throw failed(name, where, 0, errno);
    auto file = std::make_shared<Descriptor>(fd);
    if (::unlink(path.c_str()) != 0) throw failed(name, where, 0, errno);
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

}  // namespace

std::shared_ptr<const Descriptor> spool(const Descriptor& from, const std::string& name) {
    const std::string where = folder();
    auto file = make_unlinked(name, where);
    std::vector<char> buffer(1 << 20);
    std::int64_t total = 0;
    for (;;) {
        const auto got = ::read(from.get(), buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) {
            throw Error(ErrorKind::io, fmt::format("cannot read '{}' after {:.1f} MB: {}", name,
                                                   static_cast<double>(total) / 1e6, std::strerror(errno)));
        }
        if (got == 0) return file;
        if (const int why = write_all(file->get(), std::span(buffer).first(static_cast<std::size_t>(got)))) {
            throw failed(name, where, total, why);
        }
        total += got;
    }
}

}  // namespace vvr::video
