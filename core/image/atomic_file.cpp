#include "core/image/atomic_file.h"

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/error.h"
#include "core/fnv.h"

namespace vvr {

namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
    return std::generic_category().message(error);
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// How the hidden files of a target begin. A hash, as the target's name may be as long as a name can be.
std::string hidden_prefix(const std::string& name) {
    return fmt::format(".vvr-{:016x}-", fnv1a(name));
}

constexpr std::string_view hidden_ending = ".part";

/// A new file with a hidden name, gone again unless it was renamed.
class TemporaryFile {
  public:
    explicit TemporaryFile(const fs::path& target) {
        const fs::path folder = folder_of(target);
        for (int i = 0; file_ < 0; ++i) {
            path_ = folder /
                    fmt::format("{}{}-{}{}", hidden_prefix(target.filename().string()), ::getpid(), i, hidden_ending);
            file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (file_ < 0 && errno != EEXIST) throw_error("make a file in", folder, errno);
        }
    }
    ~TemporaryFile() {
        if (file_ >= 0) ::close(file_);
        if (!path_.empty()) ::unlink(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    void write(std::span<const std::byte> bytes, const fs::path& target) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(file_, bytes.data(), bytes.size());
            if (written >= 0) {
                bytes = bytes.subspan(static_cast<std::size_t>(written));
            } else if (errno != EINTR) {
                throw_error("write", target, errno);
            }
        }
    }

    void rename_to(const fs::path& target) {
        if (::fsync(file_) != 0 || ::close(std::exchange(file_, -1)) != 0 ||
            ::rename(path_.c_str(), target.c_str()) != 0) {
            throw_error("write", target, errno);
        }
        path_.clear();
    }

  private:
    [[noreturn]] static void throw_error(const char* what, const fs::path& path, int error) {
        const bool full = error == ENOSPC || error == EFBIG || error == EDQUOT;
        throw Error(ErrorKind::io, fmt::format("cannot {} '{}': {}; {}", what, path.string(), reason(error),
                                               full ? "free some space or choose another folder"
                                                    : "choose another folder or mend its permissions"));
    }

    fs::path path_;
    int file_ = -1;
};

/// Where the bytes go when `path` is a link to another file.
fs::path target_of(const fs::path& path) {
    std::error_code error;
    if (!fs::is_symlink(path, error)) return path;
    fs::path target = fs::weakly_canonical(path, error);
    if (error) {
        throw Error(
            ErrorKind::io,
            fmt::format("cannot write '{}': it is a link that can't be followed: {}; remove it, or choose another "
                        "name",
                        path.string(), error.message()));
    }
    return target;
}

}  // namespace

void check_file_path(const fs::path& path) {
    const fs::path target = target_of(path);
    const fs::path folder = folder_of(target);
    std::error_code error;
    const fs::file_status place = fs::status(folder, error);
    if (place.type() == fs::file_type::not_found) {
        throw Error(ErrorKind::io,
                    fmt::format("cannot write '{}': there is no folder '{}'; make it with: mkdir -p '{}'",
                                path.string(), folder.string(), folder.string()));
    }
    if (error) {
        throw Error(ErrorKind::io,
                    fmt::format("cannot write '{}': folder '{}': {}", path.string(), folder.string(), error.message()));
    }
    if (place.type() != fs::file_type::directory) {
        throw Error(ErrorKind::io, fmt::format("cannot write '{}': '{}' is not a folder; choose another one",
                                               path.string(), folder.string()));
    }
    const fs::file_status there = fs::status(target, error);
    if (fs::exists(there) && !fs::is_regular_file(there)) {
        throw Error(ErrorKind::io, fmt::format("cannot write '{}': it is {}; give the name of a file", path.string(),
                                               fs::is_directory(there) ? "a folder" : "not a regular file"));
    }
    if (fs::exists(there) && ::access(target.c_str(), W_OK) != 0) {
        throw Error(ErrorKind::io, fmt::format("cannot write '{}': {}; remove it, or choose another name",
                                               path.string(), reason(errno)));
    }
    // Asking for permissions is not enough: a server or a full disk has its own opinion. So try.
    const TemporaryFile probe(target);
}

void replace_file(const fs::path& path, std::span<const std::byte> bytes) {
    const fs::path target = target_of(path);
    TemporaryFile file(target);
    file.write(bytes, path);
    file.rename_to(target);
}

void remove_leftovers(const fs::path& folder, std::span<const std::string> names) {
    std::vector<std::string> prefixes;
    for (const std::string& name : names) prefixes.push_back(hidden_prefix(name));
    std::error_code none;
    std::vector<fs::path> left;
    for (fs::directory_iterator entry(folder, none); !none && entry != fs::directory_iterator();
         entry.increment(none)) {
        const std::string name = entry->path().filename().string();
        const bool ours =
            name.ends_with(hidden_ending) &&
            std::ranges::any_of(prefixes, [&](const std::string& prefix) { return name.starts_with(prefix); });
        if (ours) left.push_back(entry->path());
    }
    for (const fs::path& path : left) fs::remove(path, none);
}

}  // namespace vvr
