#include "cli/app/shown_name.h"

#include <algorithm>
#include <filesystem>

#include "core/video/input.h"

namespace vvr::app {

std::string shown_name(const std::string& input) {
    namespace fs = std::filesystem;
    if (input == "-") return "stdin";
    std::string path = input;
    if (video::is_url(input)) {
        path = input.substr(input.find("://") + 3);
        path.resize(std::min(path.size(), path.find_first_of("?#")));
        path = path.find('/') == std::string::npos ? "" : path.substr(path.find('/'));
    }
    const fs::path whole = fs::path(path).lexically_normal();
    const std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
    return name.empty() || name == "/" || name == "." ? "a clip" : name;
}

std::string title_of(const std::string& asked, const video::VideoInfo& clip) {
    if (!asked.empty()) return asked;
    return clip.title.empty() ? shown_name(clip.name) : clip.title;
}

}  // namespace vvr::app
