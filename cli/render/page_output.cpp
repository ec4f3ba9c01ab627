#include "cli/render/page_output.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/render/shown_name.h"
#include "core/page/text.h"

namespace vvr {

namespace fs = std::filesystem;

namespace {

/// Where the page belongs in an archive whose index lies above it: archives name a page after its clip.
PageIndex index_of(const fs::path& page, const fs::path& index) {
    const std::string below = relative_url(index, page);
    return {relative_url(page, index), below.substr(0, below.size() - page.extension().string().size())};
}

}  // namespace

std::string page_text(const RenderJob& job, const RenderReport& report, Picture picture, const Metadata& settings,
                      Moments moments, const std::optional<LiveState>& live) {
    std::error_code none;
    const fs::path& path = page_of(job.output);
    const std::string& input = job.input.names.front();
    PageContent content;
    content.name = title_of(job.look.title, report.info);
    for (const SegmentPlace& segment : report.info.segments) {
        if (segment.end <= segment.begin) continue;  // another file shows the same time
        content.segments.push_back({relative_url(path, segment.path), segment.begin, segment.end - segment.begin});
    }
    const bool is_file = !live && content.segments.empty() && fs::is_regular_file(input, none);
    if (is_file) content.clip_url = relative_url(path, input);
    content.shown = report.info.size;
    content.field = report.field_size;
    content.picture = std::move(picture);
    content.settings = settings;
    content.moments = std::move(moments);
    content.clock = report.clock;
    content.events = report.events;
    content.numbers = report.event_numbers;
    content.colours = report.event_colours;
    content.portraits = report.portraits;
    content.live = live;
    if (!job.output.page_index.empty()) content.index = index_of(path, job.output.page_index);
    for (const Region& region : report.lettering.regions) content.regions.push_back({region.box, region.number});
    return make_page(content);
}

}  // namespace vvr
