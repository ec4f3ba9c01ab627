#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Which parts of a path may name a camera.
namespace vvr::footage {

/// The folders before the first date folder, or else the first folder after it that is not a date or hour. Empty if
/// there is none.
/// \param skipped leading bytes of `path` whose folders are not a camera, but may be a date
std::string camera_of_folders(std::string_view path, std::size_t skipped);

/// Whether a name is generic, not a camera's: "VID", "clip 7", "recordings", "001".
bool is_generic_name(std::string_view name);

/// Files with the same result are numbered together: the folders of their camera, and the word before the number.
/// \param numbered a generic name with a number: "video1"
std::string numbered_with(std::string_view path, std::string_view numbered);

}  // namespace vvr::footage
