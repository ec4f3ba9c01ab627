#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vvr::video {

/// The files of this machine that are read where `name` is given as an input: a file, those that a folder, a pattern or
/// a list names, what stdin is (`-`), or the file that holds an address (`@FILE`). All that may be read counts, be it a
/// clip, a picture, or part of an extraction. What can't be looked at is left out: who opens it says why.
std::vector<std::filesystem::path> files_of_input(const std::string& name);

}  // namespace vvr::video
