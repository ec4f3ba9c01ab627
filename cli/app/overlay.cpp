#include "cli/app/overlay.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/annotation/portraits.h"
#include "core/annotation/ruler.h"
#include "core/annotation/scene_map.h"
#include "core/annotation/time_ticks.h"
#include "core/image/picture.h"

namespace vvr::app {

namespace {

/// Cross-sections of the volume, evenly spread over the time axis: enough for straight lines between them.
std::vector<page::Overlay::Section> sections_of(const Plan& plan, const Observation& seen,
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
            section.corners[corner] = camera.pixel(plan.layout->p_from_c({x, y, t}), plan.job.picture.size);
        }
        sections.push_back(section);
    }
    return sections;
}

/// The texts along the ruler, the most important first.
std::vector<page::Overlay::Note> notes_of(const Plan& plan, const Observation& seen, const Composition& composed) {
    std::vector<page::Overlay::Note> notes;
    if (!plan.shows(Part::ruler)) return notes;
    const volume::Volume& volume = seen.volume;
    const Framing& framing = composed.framing;
    const auto add = [&](const std::string& text, double t) {
        const annotation::MarkInPicture mark =
            annotation::mark_in_picture(*plan.layout, framing.edge, t, framing.camera, plan.job.picture.size);
        notes.push_back({text, mark.end, mark.out});
    };
    for (const annotation::TimeGap& gap : explained_gaps(plan, seen)) add(gap.reason, (gap.t_begin + gap.t_end) / 2);
    const std::vector<annotation::TimeTick>& ticks = composed.ticks;
    if (!ticks.empty()) add(ticks.front().text, volume.t_of_seconds(ticks.front().seconds));
    for (std::size_t k = ticks.size(); k-- > 1;) add(ticks[k].text, volume.t_of_seconds(ticks[k].seconds));
    for (const annotation::TimeBreak& gap : annotation::time_breaks(volume, breaks_shown))
        add(fmt::format("{} idle", annotation::format_duration(gap.seconds)), gap.t);
    return notes;
}

std::vector<page::Overlay::Portrait> portraits_of(const Plan& plan, const Observation& seen,
                                                  const Composition& composed) {
    std::vector<page::Overlay::Portrait> portraits;
    if (!plan.shows(Part::portraits) || composed.framing.sheet.text == 0) return portraits;
    const annotation::Objects& objects = composed.objects;
    const annotation::Trails trails(seen.volume, *plan.layout, composed.framing.camera, plan.job.picture.size);
    std::vector<std::size_t> all(objects.events.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (const annotation::EventPortrait& placed : annotation::event_portraits(
             objects, std::set(all.begin(), all.end()), seen.crops, trails, composed.framing.sheet, {})) {
        portraits.push_back({placed.event, placed.still, placed.to});
    }
    return portraits;
}

}  // namespace

page::Overlay overlay_of(const Plan& plan, const Observation& seen, const Composition& composed) {
    const annotation::Sheet& sheet = composed.framing.sheet;
    page::Overlay overlay;
    overlay.sections = sections_of(plan, seen, composed.framing.camera);
    overlay.notes = notes_of(plan, seen, composed);
    overlay.portraits = portraits_of(plan, seen, composed);
    overlay.captions = sheet.captions;
    overlay.numbers = plan.shows(Part::numbers);
    if (plan.shows(Part::map) && !seen.scene.empty() && sheet.text > 0) {
        const Size field = plan.clip.field_size;
        overlay.map = annotation::map_box(*plan.layout, composed.framing.camera, sheet.picture, sheet.map_area,
                                          static_cast<double>(field.width) / field.height);
        if (!overlay.map.empty()) overlay.scene = image::resized(seen.scene, overlay.map.size());
    }
    return overlay;
}

}  // namespace vvr::app
