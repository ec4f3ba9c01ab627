#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

// The files that an archive has in its folder of pictures. Others may write there too: what stands in the place of such
// a file and is none is named, and left alone.
namespace vvr::archive {

/// What stands at a path where a file should: "a link", "a pipe"; nothing for a file, and where nothing is.
std::optional<std::string_view> irregular_file_at(const std::filesystem::path& path);

/// \throws Error io when something else than a file is where one is to be written
void check_own_place(const std::filesystem::path& file);

/// \param folder `out`, or below it
/// \throws Error io when something else than a folder is on the way from `out` to `folder`: a link leads elsewhere
void check_own_folder(const std::filesystem::path& out, const std::filesystem::path& folder);

/// What is read of such a file.
struct OwnText {
    std::optional<std::string> text;  ///< nothing when it is not there, or does not begin as asked
    std::string problem;              ///< why it can't be read although it is there; empty = none
};

/// All of a file that begins with `beginning`. No link is followed, nothing is waited for, and of what begins otherwise
/// or is too large no more is read.
OwnText read_own(const std::filesystem::path& file, std::string_view beginning, std::size_t most);

}  // namespace vvr::archive
