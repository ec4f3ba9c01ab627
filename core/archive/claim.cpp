#include "core/archive/claim.h"

#include <array>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/error.h"
#include "core/fnv.h"

namespace vvr {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = ".vvr-";
constexpr std::string_view ending = ".lock";

/// A hash, as the name itself may be as long as a name can be.
fs::path file_for(const fs::path& folder, const std::string& name) {
    return folder / fmt::format("{}{:016x}{}", prefix, fnv1a(name), ending);
}

[[noreturn]] void refuse(const fs::path& path, int error) {
    const bool full = error == ENOSPC || error == EDQUOT;
    const char* next = full ? "free some space or choose another folder"
                            : "choose a folder that can be written to, on a file system with locks";
    throw Error(ErrorKind::io,
                fmt::format("cannot lock '{}': {}; {}", path.string(), std::generic_category().message(error), next));
}

bool is_still(int file, const fs::path& path) {
    struct stat ours {
    }, there{};
    return ::fstat(file, &ours) == 0 && ::stat(path.c_str(), &there) == 0 && ours.st_ino == there.st_ino &&
           ours.st_dev == there.st_dev;
}

int lock(int file, bool wait) {
    int result = 0;
    do result = ::flock(file, wait ? LOCK_EX : LOCK_EX | LOCK_NB);
    while (result != 0 && errno == EINTR);
    return result;
}

}  // namespace

Claim::Claim(fs::path path, int file, bool left_behind)
    : path_(std::move(path)), file_(file), left_behind_(left_behind) {}

Claim::Claim(Claim&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)), left_behind_(other.left_behind_) {}

Claim::~Claim() {
    if (file_ < 0) return;
    ::unlink(path_.c_str());
    ::close(file_);
}

std::optional<Claim> Claim::take(const fs::path& path, const std::string& name, bool wait) {
    for (;;) {
        const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (file < 0) refuse(path, errno);
        if (lock(file, wait) != 0) {
            const int error = errno;
            ::close(file);
            if (error == EWOULDBLOCK) return std::nullopt;
            refuse(path, error);
        }
        // Who had it removes the file, so what is locked now may be no file any more.
        if (!is_still(file, path)) {
            ::close(file);
            continue;
        }
        struct stat status {};
        // Who takes a claim writes its name in before anything else.
        const bool left_behind = ::fstat(file, &status) == 0 && status.st_size > 0;
        Claim claim(path, file, left_behind);
        if (!left_behind && ::write(file, name.data(), name.size()) != static_cast<ssize_t>(name.size())) {
            refuse(path, errno);
        }
        return claim;
    }
}

std::optional<Claim> Claim::try_take(const fs::path& folder, const std::string& name) {
    return take(file_for(folder, name), name, false);
}

Claim Claim::wait_for(const fs::path& folder, const std::string& name) {
    return *take(file_for(folder, name), name, true);
}

bool Claim::is_claim(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.size() == prefix.size() + 16 + ending.size() && name.starts_with(prefix) && name.ends_with(ending);
}

std::optional<std::pair<Claim, std::string>> Claim::take_over(const fs::path& file) {
    const int open = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
    if (open < 0) return std::nullopt;
    if (lock(open, false) != 0 || !is_still(open, file)) {
        ::close(open);
        return std::nullopt;
    }
    Claim claim(file, open, true);
    std::array<char, 4096> name{};
    const ssize_t length = ::pread(open, name.data(), name.size(), 0);
    return std::pair(std::move(claim), std::string(name.data(), length > 0 ? static_cast<std::size_t>(length) : 0));
}

}  // namespace vvr
