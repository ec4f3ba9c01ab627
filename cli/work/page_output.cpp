#include "cli/work/page_output.h"

#include <system_error>
#include <utility>

#include "core/page/page.h"
#include "core/page/text.h"
#include "core/video/input.h"

namespace vvr {

namespace {

namespace fs = std::filesystem;

/// A name without its folders, which are nobody's business. Of an address neither who may see it is told, nor by what
/// word.
std::string shown_name(const std::string& input) {
    if (input == "-") return "stdin";
    std::string path = input;
    if (is_url(input)) {
        path = input.substr(input.find("://") + 3);
        path = path.substr(0, path.find_first_of("?#"));
        path = path.find('/') == std::string::npos ? "" : path.substr(path.find('/'));
    }
    const fs::path whole = fs::path(path).lexically_normal();
    const std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
    return name.empty() || name == "/" || name == "." ? "a clip" : name;
}

}  // namespace

std::string page_text(const fs::path& path, const std::string& input, const RenderReport& report, Picture picture,
                      const Metadata& settings, Moments moments) {
    std::error_code none;
    PageContent content;
    content.name = shown_name(input);
    if (fs::is_regular_file(input, none)) content.clip_url = relative_url(path, input);
    content.shown = report.info.size;
    content.field = report.field_size;
    content.picture = std::move(picture);
    content.settings = settings;
    content.moments = std::move(moments);
    content.events = report.events;
    return make_page(content);
}

}  // namespace vvr
