#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

// The folder of the pieces of a clip's events. Others may write there too: only files whose names vvr gives, and that a
// sidecar lists, are vvr's.
namespace vvr::archive {

/// `cam1/x.avi` has `cam1/x.avi.events`.
std::filesystem::path pieces_folder(const std::filesystem::path& out, const std::string& clip);

/// Whether a folder is one of pieces that vvr has kept, of any archive.
bool is_pieces_folder(const std::filesystem::path& folder);

/// The names of files in the folder that vvr may have written, sorted. None if it is a link.
std::vector<std::string> list_pieces(const std::filesystem::path& folder);

/// Whether all of these are files in the folder.
bool has_pieces(const std::filesystem::path& folder, std::span<const std::string> names);

/// Moves pieces into the folder, which is created if missing.
/// \throws Error io, also if a link or a folder is in the place of one
void move_pieces(const std::filesystem::path& from, const std::filesystem::path& folder,
                 std::span<const std::string> names);

/// Removes these files from the folder, then the folder if it is empty. Anything else stays.
/// \returns what was removed
/// \throws Error io
std::vector<std::filesystem::path> remove_pieces(const std::filesystem::path& folder,
                                                 std::span<const std::string> names);

}  // namespace vvr::archive
