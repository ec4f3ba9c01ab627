#include "cli/shader_cache.h"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>

#include <pwd.h>
#include <unistd.h>

namespace vvr::cli {

namespace {

namespace fs = std::filesystem;

/// The parent folder of Mesa's shader cache.
std::optional<fs::path> cache_folder() {
    for (const char* name : {"MESA_SHADER_CACHE_DIR", "XDG_CACHE_HOME"}) {
        if (const char* const folder = std::getenv(name)) return folder;
    }
    if (const char* const home = std::getenv("HOME")) return fs::path(home) / ".cache";
    const passwd* const user = ::getpwuid(::getuid());
    return user == nullptr || user->pw_dir == nullptr ? std::nullopt : std::optional(fs::path(user->pw_dir) / ".cache");
}

/// Mesa creates the folder itself, but not its parents.
bool can_be_written(const fs::path& folder) {
    std::error_code none;
    const fs::path existing = fs::exists(folder, none) ? folder : folder.parent_path();
    return fs::is_directory(existing, none) && ::access(existing.c_str(), W_OK) == 0;
}

}  // namespace

void choose_shader_cache() {
    const std::optional<fs::path> folder = cache_folder();
    if (folder && can_be_written(*folder)) {
        ::setenv("MESA_SHADER_CACHE_DIR", folder->c_str(), 0);
    } else {
        ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
    }
}

}  // namespace vvr::cli
