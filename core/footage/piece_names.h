#pragma once

#include <cstdint>
#include <string>
#include <string_view>

// The names of files in a folder of pieces. None of them comes from a clip or a camera, so none can be hostile.
namespace vvr::footage {

inline constexpr std::string_view record_name = "evidence.json";  ///< says where the pieces come from
inline constexpr std::string_view sums_name = "SHA256SUMS";       ///< for `sha256sum -c`, of all files beside it

/// "event-3.mp4"
/// \param number of the first event in the piece
/// \param extension with its dot
std::string piece_name(std::int64_t number, std::string_view extension);

/// Whether vvr gives a file in such a folder this name.
bool is_piece_name(std::string_view name);

}  // namespace vvr::footage
