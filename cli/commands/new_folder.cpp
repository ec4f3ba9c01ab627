#include "cli/commands/new_folder.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/digest.h"
#include "core/base/error.h"

namespace vvr::commands {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, int error) {
    throw system_error(error, fmt::format("cannot create the folder '{}'", path.string()), "choose another folder");
}

}  // namespace

void check_is_free(const fs::path& path, std::string_view setting) {
    std::error_code error;
    const fs::file_status there = fs::symlink_status(path, error);
    if (!fs::exists(there)) return;
    if (!fs::is_directory(there)) {
        throw Error(
            ErrorCode::not_a_folder,
            fmt::format("cannot create the folder '{}': a file is in its place; choose another name", path.string()),
            {setting});
    }
    const bool is_empty = fs::is_empty(path, error);
    if (error)
        throw system_error(error.value(), fmt::format("cannot list the folder '{}'", path.string()),
                           "fix its permissions or choose another folder");
    if (is_empty) return;
    throw Error(ErrorCode::folder_not_empty,
                fmt::format("'{}' has files already; choose a new or an empty folder", path.string()), {setting});
}

NewFolder::NewFolder(fs::path path, std::string_view setting) : path_(std::move(path)) {
    if (!path_.has_filename()) path_ = path_.parent_path();
    check_is_free(path_, setting);
    const fs::path parent = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
    if (::access(parent.c_str(), W_OK | X_OK) != 0) refuse(path_, errno);
    const std::string name = path_.filename().string();
    std::optional<LockFile> lock = LockFile::try_take(parent, name);
    if (!lock) {
        throw Error(ErrorCode::file_locked,
                    fmt::format("cannot create the folder '{}': another vvr is writing it; wait until it has ended, or "
                                "choose another folder",
                                path_.string()),
                    {setting});
    }
    lock_.emplace(std::move(*lock));
    // A hash, because the name may already have the maximum length.
    hidden_ = parent / fmt::format(".vvr-{:016x}.new", fnv1a(name));
    std::error_code none;
    fs::remove_all(hidden_, none);  // left by a killed run
    struct stat replaced {};
    const bool replaces = ::lstat(path_.c_str(), &replaced) == 0;
    // A folder that may be private is never open to others on the way, and stays private if it can't have its group.
    if (::mkdir(hidden_.c_str(), replaces ? 0700 : 0777) != 0) {
        const int error = errno;
        hidden_.clear();  // somebody else's
        refuse(path_, error);
    }
    if (replaces && ::chown(hidden_.c_str(), ::geteuid(), replaced.st_gid) == 0)
        ::chmod(hidden_.c_str(), replaced.st_mode & 07777);
}

NewFolder::~NewFolder() {
    std::error_code none;
    if (!hidden_.empty()) fs::remove_all(hidden_, none);
}

void NewFolder::publish() {
    std::error_code error;
    fs::rename(hidden_, path_, error);
    if (error) refuse(path_, error.value());
    hidden_.clear();
}

}  // namespace vvr::commands
