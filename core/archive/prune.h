#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/archive/sidecar.h"

namespace vvr {

/// The files in an archive's folder of pictures that belong to the archive.
struct Outputs {
    std::vector<Sidecar> sidecars;              ///< by path
    std::vector<std::filesystem::path> claims;  ///< files of claims, of running or of killed programs
};

/// \param in the folder of clips; skipped if it is inside `out`
/// \throws Error io
Outputs list_outputs(const std::filesystem::path& out, const std::filesystem::path& in);

/// Removes the files and claims of killed programs that no later run would finish. Neither the index nor files of other
/// clips are removed.
void tidy(const std::filesystem::path& out, const Outputs& outputs);

/// The names of all files that are written for a clip; for the index, its own name.
std::vector<std::string> written_names(const std::string& file_name);

/// Whether it is certain that there is no such file. Without permission to look, it is not.
bool is_gone(const std::filesystem::path& path);

/// The clips that no longer exist.
struct Gone {
    std::vector<Sidecar> sidecars;
    std::vector<std::string> empty_folders;  ///< that held clips; they may be disks that are not mounted
};

/// \throws Error io when the archive has no clips at all: most probably a disk is not mounted
Gone find_gone(const std::filesystem::path& in, const std::vector<Sidecar>& sidecars, std::size_t clips_there);

}  // namespace vvr
