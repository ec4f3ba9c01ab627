#include "cli/app/output.h"

#include <string>

#include "core/base/ending.h"
#include "core/image/animation_file.h"

namespace vvr::app {

image::NamePattern name_of(const OutputOptions& options) {
    return options.plain_name ? image::NamePattern::literal(options.path) : image::NamePattern(options.path);
}

bool is_series(const OutputOptions& options) {
    return options.slide || (!options.animate && name_of(options).has_field());
}

bool is_page(const std::filesystem::path& path) {
    const std::string ending = extension_of(path);
    return ending == ".html" || ending == ".htm";
}

const std::filesystem::path& page_of(const OutputOptions& options) {
    return is_page(options.path) ? options.path : options.page;
}

int pictures_of(const OutputOptions& options) {
    if (options.path.empty() && options.golden.path.empty()) return 0;
    if (options.slide) return *options.slide;
    return options.animate.value_or(image::is_animation(options.path) ? default_animation : 1);
}

}  // namespace vvr::app
