#pragma once

#include <string>
#include <vector>

namespace vvr::cli {

struct LibraryVersion {
    std::string name;
    std::string version;
};

/// The versions with which vvr was built. Asking the libraries would need to load them.
std::vector<LibraryVersion> library_versions();

/// The versions of vvr and its libraries, one per line. OpenGL's renderer is left to `vvr doctor`, as asking for it
/// takes longer than all the rest.
std::string version_text();

}  // namespace vvr::cli
