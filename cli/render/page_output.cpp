#include "cli/render/page_output.h"

#include <system_error>
#include <utility>

#include "cli/render/shown_name.h"
#include "core/page/page.h"
#include "core/page/text.h"

namespace vvr {

namespace fs = std::filesystem;

std::string page_text(const fs::path& path, const std::string& input, const std::string& title,
                      const RenderReport& report, Picture picture, const Metadata& settings, Moments moments) {
    std::error_code none;
    PageContent content;
    content.name = title_of(title, report.info);
    for (const SegmentPlace& segment : report.info.segments) {
        if (segment.end <= segment.begin) continue;  // another file shows the same time
        content.segments.push_back({relative_url(path, segment.path), segment.begin, segment.end - segment.begin});
    }
    if (content.segments.empty() && fs::is_regular_file(input, none)) content.clip_url = relative_url(path, input);
    content.clock = report.clock;
    content.shown = report.info.size;
    content.field = report.field_size;
    content.picture = std::move(picture);
    content.settings = settings;
    content.moments = std::move(moments);
    content.events = report.events;
    content.colours = report.event_colours;
    for (const Region& region : report.lettering.regions) content.regions.push_back({region.box, region.number});
    return make_page(content);
}

}  // namespace vvr
