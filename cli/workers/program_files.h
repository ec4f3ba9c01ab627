#pragma once

#include <filesystem>
#include <vector>

#include "cli/workers/landlock.h"

namespace vvr::workers {

/// A file that drawing needs, or all below a folder.
struct ProgramFile {
    std::filesystem::path path;
    Use use;
};

/// What any run of this program reads of the machine, whatever it draws: the program and its libraries, OpenGL drivers
/// and their cache of shaders, fonts, and what the kernel says of processors and memory. Some of them may not be there.
/// \param gpu a graphics card as well
std::vector<ProgramFile> program_files(bool gpu);

}  // namespace vvr::workers
