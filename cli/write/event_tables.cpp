#include "cli/write/event_tables.h"

#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cli/observe/track_boxes.h"
#include "cli/plan/video_scale.h"
#include "core/tracking/event.h"
#include "core/tracking/event_line.h"

namespace vvr::app {

std::string tracks_table(const RunContext& context) {
    const auto& [plan, seen, composed, run] = context;
    if (!seen.events) return {};
    const std::vector<std::optional<std::size_t>> events = tracking::events_of_tracks(seen.events->events);
    // A track may begin before the object came, when its place differed from the empty scene.
    std::map<std::pair<std::int64_t, std::size_t>, PixelBox> boxes;
    for (const TrackBox& one : seen.track_boxes) {
        if (one.track >= events.size() || !events[one.track]) continue;
        const tracking::Event& event = seen.events->events[*events[one.track]];
        if (one.frame < event.first.frame || one.frame > event.last.frame) continue;
        const auto [at, is_new] = boxes.try_emplace({one.frame, *events[one.track]}, one.box);
        if (!is_new) at->second = bounding_box(at->second, one.box);
    }
    // The fields don't show an object that the empty scene has, so its track ends before it lies there.
    for (std::size_t k = 0; k < seen.events->events.size(); ++k) {
        const tracking::Event& event = seen.events->events[k];
        if (!event.in_scene) continue;
        for (std::int64_t frame = event.first.frame; frame <= event.last.frame; ++frame) {
            boxes.try_emplace({frame, k}, event.in_scene->box);
        }
    }
    const VideoScale scale(plan.read.clip.field_size, seen.info.size);
    std::string text;
    for (const auto& [place, field_box] : boxes) {
        const PixelBox box = scale(field_box);
        text += fmt::format("{},{},{},{},{},{},1,-1,-1,-1\n", place.first + 1, seen.events->numbers[place.second],
                            box.left + 1, box.top + 1, box.width(), box.height());
    }
    return text;
}

}  // namespace vvr::app
