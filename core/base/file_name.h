#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <climits>

namespace vvr {

/// The ending of a file's name with its dot, in lower case: `.png` of `out.PNG`. Empty where there is none.
inline std::string extension_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

/// Bytes that a file's name can have.
inline constexpr std::size_t longest_name = NAME_MAX;

/// The gate for every name that stands in a file: others may have written that file. Whether it is the name of
/// something in a folder, and can lead to no other folder and to nothing that is no file's name.
constexpr bool is_plain_name(std::string_view name) {
    return !name.empty() && name.size() <= longest_name && name != "." && name != ".." &&
           name.find_first_of(std::string_view("/\0", 2)) == std::string_view::npos;
}

/// The same for a path that stands in a file: plain names with a `/` between them, so that it stays below its folder.
constexpr bool is_plain_path(std::string_view path) {
    for (auto slash = path.find('/'); slash != std::string_view::npos; slash = path.find('/')) {
        if (!is_plain_name(path.substr(0, slash))) return false;
        path.remove_prefix(slash + 1);
    }
    return is_plain_name(path);
}

}  // namespace vvr
