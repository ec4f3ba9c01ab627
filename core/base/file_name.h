#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <climits>

namespace vvr {

/// The extension with its dot, in lower case: `.png` of `out.PNG`. Empty if there is none.
inline std::string extension_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// Maximum length of a file's name, in bytes.
inline constexpr std::size_t longest_name = NAME_MAX;

/// Whether a name is safe to use in a folder: it can't lead to another folder and is a valid file name. Check every
/// name read from a file, because others may have written the file.
constexpr bool is_plain_name(std::string_view name) {
    return !name.empty() && name.size() <= longest_name && name != "." && name != ".." &&
           name.find_first_of(std::string_view("/\0", 2)) == std::string_view::npos;
}

/// Whether all components of a relative path are plain names, so that it stays below its folder.
constexpr bool is_plain_path(std::string_view path) {
    for (auto slash = path.find('/'); slash != std::string_view::npos; slash = path.find('/')) {
        if (!is_plain_name(path.substr(0, slash))) return false;
        path.remove_prefix(slash + 1);
    }
    return is_plain_name(path);
}

}  // namespace vvr
