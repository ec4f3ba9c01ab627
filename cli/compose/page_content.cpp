#include "cli/compose/page_content.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/compose/turning_volume.h"
#include "core/annotation/portraits.h"
#include "core/annotation/ruler.h"
#include "core/annotation/scene_map.h"
#include "core/annotation/time_ticks.h"
#include "core/image/picture.h"
#include "core/page/html.h"

namespace vvr::app {

namespace {

/// Cross-sections of the volume, evenly spread over the time axis: enough for straight lines between them.
std::vector<page::Overlay::Section> sections_of(const ComposePlan& plan, const Observation& seen,
                                                const space::Camera& camera) {
    constexpr std::int64_t most = 192;
    const volume::Volume& volume = seen.volume;
    std::vector<page::Overlay::Section> sections;
    const std::int64_t count = std::min(most, volume.layers());
    for (std::int64_t k = 0; k <= count && count > 0; ++k) {
        const std::int64_t layer = k * volume.layers() / count;
        const bool at_end = layer == volume.layers();
        page::Overlay::Section section;
        section.seconds = at_end ? volume.layer(layer - 1).last_pts : volume.layer(layer).pts;
        const double t = at_end ? volume.t_end() : volume.t_of_layer(layer);
        // The corners of the frame in order: upper left, upper right, lower right, lower left.
        constexpr std::array<std::pair<double, double>, 4> corners{{{1, 1}, {0, 1}, {0, 0}, {1, 0}}};
        for (std::size_t corner = 0; corner < corners.size(); ++corner) {
            const auto& [x, y] = corners[corner];
            section.corners[corner] = camera.pixel(plan.look.layout->p_from_c({x, y, t}), plan.look.picture.size);
        }
        sections.push_back(section);
    }
    return sections;
}

/// The texts along the ruler, the most important first.
std::vector<page::Overlay::Note> notes_of(const ComposePlan& plan, const Observation& seen,
                                          const Composition& composed) {
    std::vector<page::Overlay::Note> notes;
    if (!plan.look.shows(Part::ruler)) return notes;
    const volume::Volume& volume = seen.volume;
    const Framing& framing = composed.framing;
    const auto add = [&](const std::string& text, double t) {
        const annotation::MarkInPicture mark =
            annotation::mark_in_picture(*plan.look.layout, framing.edge, t, framing.camera, plan.look.picture.size);
        notes.push_back({text, t, mark.end, mark.out});
    };
    for (const annotation::TimeGap& gap : explained_gaps(plan, seen)) add(gap.reason, (gap.t_begin + gap.t_end) / 2);
    const std::vector<annotation::TimeTick>& ticks = composed.ticks;
    if (!ticks.empty()) add(ticks.front().text, volume.t_of_seconds(ticks.front().seconds));
    for (std::size_t k = ticks.size(); k-- > 1;) add(ticks[k].text, volume.t_of_seconds(ticks[k].seconds));
    for (const annotation::TimeBreak& gap : annotation::time_breaks(volume, breaks_shown))
        add(fmt::format("{} idle", annotation::format_duration(gap.seconds)), gap.t);
    return notes;
}

std::vector<page::Overlay::Portrait> portraits_of(const ComposePlan& plan, const Observation& seen,
                                                  const Composition& composed) {
    std::vector<page::Overlay::Portrait> portraits;
    if (!plan.look.shows(Part::portraits) || composed.framing.sheet.text == 0) return portraits;
    const annotation::Objects& objects = composed.objects;
    const annotation::Trails trails(seen.volume, *plan.look.layout, composed.framing.camera, plan.look.picture.size);
    std::vector<std::size_t> all(objects.events.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (const annotation::EventPortrait& placed : annotation::event_portraits(
             objects, std::set(all.begin(), all.end()), seen.crops, trails, composed.framing.sheet, {})) {
        portraits.push_back({placed.event, placed.still, placed.to});
    }
    return portraits;
}

/// What the page draws over its picture: where moments, portraits and the map are in it.
page::Overlay overlay_of(const ComposePlan& plan, const Observation& seen, const Composition& composed) {
    const annotation::Sheet& sheet = composed.framing.sheet;
    page::Overlay overlay;
    overlay.sections = sections_of(plan, seen, composed.framing.camera);
    overlay.notes = notes_of(plan, seen, composed);
    overlay.portraits = portraits_of(plan, seen, composed);
    overlay.captions = sheet.captions;
    overlay.numbers = plan.look.shows(Part::numbers);
    if (plan.look.shows(Part::map) && !seen.scene.empty() && sheet.text > 0) {
        const Size field = plan.read.clip.field_size;
        overlay.map = annotation::map_box(*plan.look.layout, composed.framing.camera, sheet.picture, sheet.map_area,
                                          static_cast<double>(field.width) / field.height);
        if (!overlay.map.empty()) overlay.scene = image::resized(seen.scene, overlay.map.size());
    }
    return overlay;
}

/// The page's place in the archive of an index in a parent folder. An archive names a page after its clip.
page::PageIndex index_of(const std::filesystem::path& page, const std::filesystem::path& index) {
    const std::string below = page::relative_url(index, page);
    return {page::relative_url(page, index), below.substr(0, below.size() - page.extension().string().size())};
}

/// The file name to show in small print; empty if the page already shows it.
std::string file_name_of(const ComposePlan& plan, const media::VideoInfo& info, const page::PageContent& content) {
    const std::string& file = plan.page.file;
    if (plan.read.input.names.size() > 1)
        return info.unread > 0 ? fmt::format("{}, {} could not be read", file, info.unread) : file;
    return content.camera.empty() && content.name == file ? "" : file;
}

}  // namespace

page::PageContent page_content(const ComposePlan& plan, const Observation& seen, const Composition& composed) {
    const PagePlan& page = plan.page;
    const bool titled = page.is_titled || !seen.info.segments.empty();
    page::PageContent content;
    content.name = plan.look.title;
    content.camera = page.camera.empty() && titled ? std::string() : plan.read.camera;
    content.heading = page.heading;
    content.file = file_name_of(plan, seen.info, content);
    for (const media::SegmentPlace& segment : seen.info.segments) {
        if (segment.end <= segment.begin) continue;  // entirely overlapped by another file
        content.segments.push_back(
            {page::relative_url(page.path, segment.path), segment.begin, segment.end - segment.begin});
    }
    if (page.plays_file) content.clip_url = page::relative_url(page.path, plan.read.input.names.front());
    content.stretch = seen.info.stretch;
    content.piece_extension = page.file_ending;
    content.names = plan.read.input.name_patterns;
    content.shown = seen.info.size;
    content.field = plan.read.clip.field_size;
    content.time_direction = plan.look.shape->time_direction;
    content.span = plan.read.span;
    content.missing = seen.missing;
    content.clock = plan.read.clock;
    if (seen.events) {
        content.events = seen.events->events;
        for (const tracking::Event& event : *content.events)
            content.activities.push_back(annotation::activity_text(event));
        if (plan.volume.series) content.numbers = seen.events->numbers;
        content.colours = composed.objects.colours;
        content.not_chosen = seen.not_chosen.size();
        content.portraits = annotation::portraits_of(seen.events->events, seen.crops);
    }
    content.unseen = unseen_of(plan, seen);
    if (!page.index.empty()) content.index = index_of(page.path, page.index);
    content.overlay = overlay_of(plan, seen, composed);
    content.turning = turning_volume(plan, seen, composed);
    return content;
}

}  // namespace vvr::app
