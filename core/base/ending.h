#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace vvr {

/// The ending of a file's name with its dot, in lower case: `.png` of `out.PNG`. Empty where there is none.
inline std::string extension_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

}  // namespace vvr
