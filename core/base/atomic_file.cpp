#include "core/base/atomic_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <ctime>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/file.h"

namespace vvr {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// The prefix of a target's temporary files. It is a hash, because the target's name may already have the maximum
/// length.
std::string hidden_prefix(const std::string& name) {
    return fmt::format(".vvr-{:016x}-", fnv1a(name));
}

constexpr std::string_view hidden_extension = ".part";

/// Whether the file system is local, so that a lock excludes all other writers.
bool is_on_this_machine(int file) {
    constexpr std::int64_t zfs = 0x2fc12fc1;
    constexpr std::array<std::int64_t, 8> systems{
        EXT4_SUPER_MAGIC, XFS_SUPER_MAGIC, BTRFS_SUPER_MAGIC,     F2FS_SUPER_MAGIC,
        TMPFS_MAGIC,      RAMFS_MAGIC,     OVERLAYFS_SUPER_MAGIC, zfs};
    struct statfs system {};
    return ::fstatfs(file, &system) == 0 && std::ranges::count(systems, std::int64_t{system.f_type}) > 0;
}

/// Whether a file is too old to be still in use by a writer.
bool is_old(int file) {
    constexpr std::time_t long_enough = 3600;
    struct stat status {};
    return ::fstat(file, &status) == 0 && status.st_mtim.tv_sec < std::time(nullptr) - long_enough;
}

/// Removes the temporary file of a killed program. Keeps locked files, anything but regular files, and recent files on
/// a network file system.
/// \param abandoned whether the caller knows that no program is writing it
void remove_if_left(const fs::path& path, bool abandoned) {
    const int file = open_no_follow(path, O_WRONLY);
    if (file < 0) return;
    const int error = lock_file(file, false);
    const bool sure = abandoned || is_old(file) || (error == 0 && is_on_this_machine(file));
    if (error != EWOULDBLOCK && sure && is_same_file(file, path)) ::unlink(path.c_str());
    ::close(file);
}

/// A temporary file with a hidden name, removed unless it was renamed. It is locked while it is written. All runs use
/// the same names, so a run finds abandoned files of earlier runs.
class TemporaryFile {
  public:
    explicit TemporaryFile(const fs::path& target) {
        const std::string prefix = hidden_prefix(target.filename().string());
        const auto numbered = [&](int i) {
            return folder_of(target) / fmt::format("{}{}{}", prefix, i, hidden_extension);
        };
        int number = 0;
        while (file_ < 0) {
            path_ = numbered(number);
            remove_if_left(path_, false);
            if (!create()) ++number;
        }
        // A second, concurrent writer may have been killed.
        remove_if_left(numbered(number + 1), false);
    }
    ~TemporaryFile() {
        // Closed last: without the lock, another run may use the name.
        if (!path_.empty() && is_same_file(file_, path_)) ::unlink(path_.c_str());
        ::close(file_);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    void write(std::int64_t offset, std::span<const std::byte> bytes, const fs::path& target) {
        while (!bytes.empty()) {
            const ssize_t written = ::pwrite(file_, bytes.data(), bytes.size(), offset);
            if (written >= 0) {
                bytes = bytes.subspan(static_cast<std::size_t>(written));
                offset += written;
            } else if (errno != EINTR) {
                throw_error("write", target, errno);
            }
        }
    }

    void rename_to(const fs::path& target) {
        // Closed after the rename, for the same reason. fsync reports disk errors.
        if (::fsync(file_) != 0) throw_error("write", target, errno);
        if (!is_same_file(file_, path_)) throw_error("write", target, ENOENT);
        if (::rename(path_.c_str(), target.c_str()) != 0) throw_error("write", target, errno);
        path_.clear();
    }

  private:
    /// \returns whether the file is new
    bool create() {
        const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file < 0 && errno == EEXIST) return false;
        if (file < 0) throw_error("create a file in", std::exchange(path_, {}).parent_path(), errno);
        // Another run may have removed it as abandoned before it was locked. Without locks, its age protects it.
        lock_file(file, true);
        if (is_same_file(file, path_)) {
            file_ = file;
        } else {
            ::close(file);
        }
        return true;
    }

    [[noreturn]] static void throw_error(const char* what, const fs::path& path, int error) {
        const bool full = code_of_system_error(error) == ErrorCode::disk_full;
        throw system_error(
            error, fmt::format("cannot {} '{}'", what, path.string()),
            full ? "free some space or choose another folder" : "choose another folder or fix its permissions");
    }

    fs::path path_;
    int file_ = -1;
};

/// The file to replace: `path`, or the target of a symbolic link, which need not exist yet.
fs::path target_of(const fs::path& path) {
    const auto is_link = [](const fs::path& file) {
        std::error_code none;
        return fs::is_symlink(file, none);
    };
    std::error_code error;
    if (!is_link(path)) return path;
    fs::path target = path;
    if (fs::exists(path, error)) {
        target = fs::canonical(path, error);
    } else {
        constexpr int most_links = 40;  // as many as the kernel follows, so that a circle of links ends
        error.clear();
        for (int links = 0; !error && links < most_links && is_link(target); ++links)
            target = folder_of(target) / fs::read_symlink(target, error);
        if (!error && is_link(target)) error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
    }
    if (error)
        throw system_error(error.value(),
                           fmt::format("cannot write '{}': its symbolic link cannot be followed", path.string()),
                           "remove the link or choose another name");
    return target;
}

}  // namespace

void check_file_path(const fs::path& path) {
    const fs::path target = target_of(path);
    const fs::path folder = folder_of(target);
    std::error_code error;
    const fs::file_status place = fs::status(folder, error);
    if (place.type() == fs::file_type::not_found) {
        throw Error(ErrorCode::file_not_found,
                    fmt::format("cannot write '{}': the folder '{}' does not exist; create it with: mkdir -p '{}'",
                                path.string(), folder.string(), folder.string()));
    }
    if (error)
        throw system_error(error.value(),
                           fmt::format("cannot write '{}': cannot use the folder '{}'", path.string(), folder.string()),
                           "choose another one");
    if (place.type() != fs::file_type::directory) {
        throw Error(ErrorCode::not_a_folder,
                    fmt::format("cannot write '{}': '{}' is not a folder; choose another folder", path.string(),
                                folder.string()));
    }
    const fs::file_status there = fs::status(target, error);
    if (fs::exists(there) && !fs::is_regular_file(there)) {
        throw Error(ErrorCode::not_a_file,
                    fmt::format("cannot write '{}': it is {}; give another file name", path.string(),
                                fs::is_directory(there) ? "a folder" : "not a regular file"));
    }
    if (fs::exists(there) && ::access(target.c_str(), W_OK) != 0)
        throw system_error(errno, fmt::format("cannot write '{}'", path.string()),
                           "fix its permissions or choose another name");
    // Permissions are not enough: a server or a full disk may still refuse, so create a file.
    const TemporaryFile probe(target);
}

void replace_file(const fs::path& path, std::span<const std::byte> bytes) {
    replace_file(path, [bytes](const WriteAt& write_at) { write_at(0, bytes); });
}

void replace_link(const fs::path& path, std::span<const std::byte> bytes) {
    TemporaryFile file(path);
    file.write(0, bytes, path);
    file.rename_to(path);
}

void replace_file(const fs::path& path, const std::function<void(const WriteAt&)>& write) {
    const fs::path target = target_of(path);
    TemporaryFile file(target);
    write([&](std::int64_t offset, std::span<const std::byte> bytes) { file.write(offset, bytes, path); });
    file.rename_to(target);
}

bool is_temporary_of(const std::string& name, const fs::path& file) {
    const std::string own = file.filename().string();
    return own.starts_with(hidden_prefix(name)) && own.ends_with(hidden_extension);
}

void remove_leftovers(const fs::path& folder, std::span<const std::string> names) {
    std::error_code none;
    std::vector<fs::path> left;
    for (fs::directory_iterator entry(folder, none); !none && entry != fs::directory_iterator();
         entry.increment(none)) {
        const bool ours =
            std::ranges::any_of(names, [&](const std::string& name) { return is_temporary_of(name, entry->path()); });
        if (ours) left.push_back(entry->path());
    }
    for (const fs::path& path : left) remove_if_left(path, true);
}

}  // namespace vvr
