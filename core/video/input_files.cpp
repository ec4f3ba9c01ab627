#include "core/video/input_files.h"

#include <fstream>
#include <system_error>

#include "core/base/ending.h"
#include "core/base/error.h"
#include "core/video/matches.h"
#include "core/video/picture_list.h"
#include "core/video/video_files.h"

namespace vvr::video {

namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

constexpr std::uintmax_t most_list_bytes = 16 * 1024 * 1024;

/// A folder is read as a recording, which has folders in it, as pictures, as an extraction, or as lists or flow.
void add_folder(const fs::path& folder, Paths& files) {
    std::error_code none;
    const bool extracted = fs::exists(folder / "manifest.json", none);
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, none);
    for (; !none && entry != fs::recursive_directory_iterator(); entry.increment(none)) {
        std::error_code ignored;
        if (!entry->is_regular_file(ignored)) continue;
        const std::string name = entry->path().filename().string();
        const std::string ending = extension_of(name);
        const bool flat = is_picture_name(name) || ending == ".txt" || ending == ".flo";
        if (extracted || is_video_name(name) || (flat && entry.depth() == 0)) files.push_back(entry->path());
    }
}

/// The files that a list names, whatever else is wrong with it.
void add_list(const fs::path& list, Paths& files) {
    std::error_code none;
    if (fs::file_size(list, none) > most_list_bytes || none) return;
    std::ifstream text(list);
    for (std::string line; std::getline(text, line);) {
        if (line.ends_with('\r')) line.pop_back();
        const fs::path file = list.parent_path() / line;
        if (!line.empty() && fs::is_regular_file(file, none)) files.push_back(file);
    }
}

void add(const std::string& name, Paths& files) {
    std::error_code none;
    if (fs::is_directory(name, none)) return add_folder(name, files);
    if (fs::is_regular_file(name, none)) {
        files.emplace_back(name);
        if (extension_of(name) == ".txt") add_list(name, files);
        return;
    }
    if (fs::exists(name, none)) return;
    for (const std::string& match : expand_glob(name)) add(match, files);
    if (name.find('%') == std::string::npos) return;
    if (const auto pictures = list_pictures(name)) files.insert(files.end(), pictures->begin(), pictures->end());
}

}  // namespace

Paths files_of_input(const std::string& name) {
    if (name == "-") return {"/dev/stdin"};
    Paths files;
    try {
        add(name, files);
        if (name.starts_with('@')) add(name.substr(1), files);
    } catch (const Error&) {
        return files;
    }
    return files;
}

}  // namespace vvr::video
