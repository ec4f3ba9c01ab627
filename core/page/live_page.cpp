#include "core/page/live_page.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/image/picture_file.h"
#include "core/page/text.h"
#include "page_files.h"

namespace vvr {

std::string make_live_page(const LivePageContent& content) {
    const Size size = content.picture.pixels.size();
    const auto png = encode_picture("page.png", content.picture, content.settings);
    const auto refresh = std::clamp(std::lround(content.brick_seconds / 2), 1L, 60L);
    return fill(page_files::live_html, {
                                           {"script policy", policy_hash(page_files::live_js)},
                                           {"style policy", policy_hash(page_files::live_css)},
                                           {"refresh", fmt::to_string(refresh)},
                                           {"name", html_text(content.name)},
                                           {"state", html_text(content.state)},
                                           {"span", html_text(content.span)},
                                           {"written", fmt::to_string(content.written)},
                                           {"brick", fmt::format("{:.0f}", std::ceil(content.brick_seconds))},
                                           {"style", std::string(page_files::live_css)},
                                           {"script", std::string(page_files::live_js)},
                                           {"picture", data_url("image/png", png)},
                                           {"width", fmt::to_string(size.width)},
                                           {"height", fmt::to_string(size.height)},
                                       });
}

}  // namespace vvr
