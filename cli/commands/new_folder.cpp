#include "cli/commands/new_folder.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

#include <sys/stat.h>

#include <fmt/format.h>

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
    if (fs::is_empty(path, error) && !error) return;
    throw Error(ErrorCode::folder_not_empty,
                fmt::format("'{}' has files already; choose a new or an empty folder", path.string()), {setting});
}

NewFolder::NewFolder(fs::path path, std::string_view setting) : path_(std::move(path)) {
    if (!path_.has_filename()) path_ = path_.parent_path();
    check_is_free(path_, setting);
    const fs::path parent = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
    std::string name = (parent / ".vvr-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) refuse(path_, errno);
    hidden_ = name;
    // mkdtemp gives the folder to its owner alone; an ordinary folder has what umask leaves.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::chmod(name.c_str(), 0777 & ~mask);
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
