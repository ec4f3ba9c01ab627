#pragma once

#include <string>
#include <vector>

namespace vvr::cli {

struct LibraryVersion {
    std::string name;
    std::string version;
};

/// Of the libraries that vvr was built with: to ask them, they would have to be loaded.
std::vector<LibraryVersion> library_versions();

/// vvr and its libraries, a line each. Asking OpenGL for its renderer takes longer than everything else that a
/// version could say, so that is left to `vvr doctor`.
std::string version_text();

}  // namespace vvr::cli
