#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Which camera a file's folders tell.
namespace vvr::video {

/// The folders before the first that is a date, else the first folder after the date that is neither date nor hour;
/// empty where there is none.
/// \param skipped bytes at the front of `path` whose folders are no camera; whether one is a date counts all the same
std::string camera_of_folders(std::string_view path, std::size_t skipped = 0);

/// Whether a name says what a file is and not which camera it is of: "VID", "clip 7", "recordings", "001".
bool is_generic_name(std::string_view name);

}  // namespace vvr::video
