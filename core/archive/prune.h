#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/archive/sidecar.h"

namespace vvr {

/// Everything in an archive's folder of pictures that is its own.
struct Outputs {
    std::vector<Sidecar> sidecars;              ///< by path
    std::vector<std::filesystem::path> claims;  ///< files of claims, held or left behind
};

/// \param in left out, should it lie within
/// \throws Error io
Outputs list_outputs(const std::filesystem::path& out, const std::filesystem::path& in);

/// Removes what killed programs left that nobody will come back to, with their claims: files, and none that are the
/// index or another clip's.
void tidy(const std::filesystem::path& out, const Outputs& outputs);

/// The names of all files that are written for a clip, or for the index under its own name.
std::vector<std::string> written_names(const std::string& file_name);

/// The clips that have gone.
struct Gone {
    std::vector<Sidecar> sidecars;
    std::vector<std::string> empty_folders;  ///< in which clips have been, and which may be disks that aren't mounted
};

/// \throws Error io when the archive has no clips at all, which it hardly ever means
Gone find_gone(const std::filesystem::path& in, const std::vector<Sidecar>& sidecars, std::size_t clips_there);

}  // namespace vvr
