#include "core/page/region_editor.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/image/picture_file.h"
#include "core/page/text.h"
#include "page_files.h"
#include "shared_files.h"

namespace vvr::page {

std::string make_region_editor(const RegionEditorContent& content) {
    constexpr int quality = 88;
    const bool masks = content.roi.empty() && !content.mask.empty();
    const nlohmann::ordered_json data{{"option", masks ? "mask" : "roi"},
                                      {"regions", masks ? content.mask : content.roi}};
    // Replaces bytes that are not UTF-8 by U+FFFD.
    const std::string name = nlohmann::ordered_json::parse(json_text(content.name));
    const std::string style = std::string(shared_files::theme_css) + std::string(page_files::region_editor_css);
    const std::string script = std::string(shared_files::common_js) + std::string(page_files::region_editor_js);
    return fill(page_files::region_editor_html,
                {
                    {"script policy", policy_hash(script)},
                    {"style policy", policy_hash(style)},
                    {"name", html_text(name)},
                    {"moment", html_text(content.moment)},
                    {"style", style},
                    {"script", script},
                    {"frame", data_url("image/jpeg", image::encode_picture("frame.jpg", content.frame, quality))},
                    {"width", fmt::to_string(content.frame.width())},
                    {"height", fmt::to_string(content.frame.height())},
                    {"data", script_json(json_text(data, -1, true))},
                });
}

}  // namespace vvr::page
