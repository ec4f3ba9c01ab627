#include "core/base/lock_file.h"

#include <array>
#include <cerrno>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/file.h"

namespace vvr {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = ".vvr-";
constexpr std::string_view lock_extension = ".lock";

/// The name has a hash, because `name` itself may already have the greatest length that a file system allows.
fs::path file_for(const fs::path& folder, const std::string& name) {
    return folder / fmt::format("{}{:016x}{}", prefix, fnv1a(name), lock_extension);
}

[[noreturn]] void refuse(const fs::path& path, int error) {
    std::error_code none;
    const fs::file_status there = fs::symlink_status(path, none);
    if (fs::exists(there) && !fs::is_regular_file(there)) {
        throw Error(ErrorCode::not_a_file, fmt::format("cannot lock '{}': it is {}; remove it", path.string(),
                                                       fs::is_symlink(there) ? "a link" : "not a regular file"));
    }
    const ErrorCode code = code_of_system_error(error);
    const char* next = code == ErrorCode::disk_full ? "free some space or choose another folder"
                                                    : "choose a writable folder on a file system with locks";
    throw system_error(error, fmt::format("cannot lock '{}'", path.string()), next);
}

/// The name that a lock's file contains. Nothing if vvr did not write it: then the file's own name doesn't match.
std::optional<std::string> name_in(int file, const fs::path& path) {
    std::array<char, longest_name + 1> bytes{};  // one more than possible, to detect longer ones
    const ssize_t length = ::pread(file, bytes.data(), bytes.size(), 0);
    if (length <= 0) return std::nullopt;
    std::string name(bytes.data(), static_cast<std::size_t>(length));
    if (!is_plain_name(name) || file_for(path.parent_path(), name) != path) return std::nullopt;
    return name;
}

}  // namespace

LockFile::LockFile(fs::path path, int file, bool left_behind)
    : path_(std::move(path)), file_(file), stale_(left_behind) {}

LockFile::LockFile(LockFile&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)), stale_(other.stale_) {}

LockFile::~LockFile() {
    if (file_ < 0) return;
    ::unlink(path_.c_str());
    ::close(file_);
}

std::optional<LockFile> LockFile::take(const fs::path& path, const std::string& name) {
    LockFile lock(path, -1, false);  // copies the path while there is no file that a lack of memory would leave behind
    for (;;) {
        const int file = open_no_follow(path, O_RDWR | O_CREAT);
        if (file < 0) refuse(path, errno);
        if (const int error = lock_file(file, false); error != 0) {
            // Where locks fail, nobody holds one. What this call has made would stay for ever.
            struct stat made {};
            if (error != EWOULDBLOCK && ::fstat(file, &made) == 0 && made.st_size == 0) ::unlink(path.c_str());
            ::close(file);
            if (error == EWOULDBLOCK) return std::nullopt;
            refuse(path, error);
        }
        // The previous owner removes the file, so the locked one may be a deleted file.
        if (!is_same_file(file, path)) {
            ::close(file);
            continue;
        }
        struct stat status {};
        // A program that takes a lock first writes the name into it.
        lock.file_ = file;
        lock.stale_ = ::fstat(file, &status) == 0 && status.st_size > 0;
        if (!lock.stale_ && ::write(file, name.data(), name.size()) != static_cast<ssize_t>(name.size())) {
            refuse(path, errno);
        }
        return lock;
    }
}

std::optional<LockFile> LockFile::try_take(const fs::path& folder, const std::string& name) {
    return take(file_for(folder, name), name);
}

LockFile LockFile::wait_for(const fs::path& folder, const std::string& name, std::chrono::milliseconds patience) {
    // Polls instead of waiting in the kernel: the owner of the lock may be stopped or a foreign program.
    constexpr std::chrono::milliseconds pause{20};
    const fs::path path = file_for(folder, name);
    const auto end = std::chrono::steady_clock::now() + patience;
    for (;;) {
        if (auto lock = take(path, name)) return std::move(*lock);
        if (std::chrono::steady_clock::now() >= end) {
            throw Error(
                ErrorCode::file_locked,
                fmt::format(
                    "cannot lock '{}' for '{}': another program has held the lock for {} s; find it with: fuser '{}'",
                    path.string(), name, patience.count() / 1000, path.string()));
        }
        std::this_thread::sleep_for(pause);
    }
}

bool LockFile::is_lock_file(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.size() == prefix.size() + 16 + lock_extension.size() && name.starts_with(prefix) &&
           name.ends_with(lock_extension);
}

bool LockFile::is_lock_of(const std::string& name, const fs::path& file) {
    return file == file_for(file.parent_path(), name);
}

std::optional<std::pair<LockFile, std::string>> LockFile::take_over(const fs::path& file) {
    const int open = open_no_follow(file, O_RDWR);
    if (open < 0) return std::nullopt;
    std::optional<std::string> name;
    if (lock_file(open, false) == 0 && is_same_file(open, file)) name = name_in(open, file);
    // A foreign file stays unchanged: so no LockFile may exist yet, because it would remove it.
    if (!name) {
        ::close(open);
        return std::nullopt;
    }
    return std::pair(LockFile(file, open, true), std::move(*name));
}

}  // namespace vvr
