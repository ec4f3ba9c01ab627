#include "cli/app/event_tables.h"

#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cli/app/track_boxes.h"
#include "cli/app/video_scale.h"
#include "core/events/event.h"
#include "core/events/event_line.h"

namespace vvr::app {

namespace {

constexpr std::string_view heading =
    "number,kind,class,score,begin,end,first_frame,last_frame,first,last,seconds,still,x,y,width,height,direction,"
    "path_length,from,into,by,open_ended\n";

std::string time_of(const WallClock& clock, double seconds) {
    return clock ? clock->iso(seconds) : std::string();
}

std::string number_of(const ShownEvents& shown, const std::optional<std::size_t>& place) {
    return place ? fmt::to_string(shown.numbers[*place]) : std::string();
}

}  // namespace

// No value has a comma or a quote: names come from tables, the rest are numbers and times.
std::string events_table(const RunContext& context) {
    const auto& [plan, seen, composed, run] = context;
    std::string text(heading);
    if (!seen.events) return text;
    const VideoScale scale(plan.clip.field_size, seen.info.size);
    const WallClock& clock = plan.clock;
    for (std::size_t k = 0; k < seen.events->events.size(); ++k) {
        const events::Event& event = seen.events->events[k];
        const PixelBox box = scale(event.box);
        text += fmt::format(
            "{},{},{},{},{},{},{},{},{:.3f},{:.3f},{:.3f},{:.3f},{},{},{},{},{},{:.1f},{},{},{},{}\n",
            seen.events->numbers[k], events::name_of(event.kind), event.identity ? event.identity->what->name : "",
            event.identity ? fmt::format("{:.3f}", event.identity->score) : "", time_of(clock, event.first.seconds),
            time_of(clock, event.last.seconds), event.first.frame, event.last.frame, event.first.seconds,
            event.last.seconds, event.last.seconds - event.first.seconds, events::stationary_seconds(event), box.left,
            box.top, box.width(), box.height(), events::direction_of(event), scale.length(event.path),
            number_of(*seen.events, event.from), number_of(*seen.events, event.into), number_of(*seen.events, event.by),
            event.open_ended);
    }
    return text;
}

std::string tracks_table(const RunContext& context) {
    const auto& [plan, seen, composed, run] = context;
    if (!seen.events) return {};
    const std::vector<std::optional<std::size_t>> events = events::events_of_tracks(seen.events->events);
    // A track may begin before the object came, when its place differed from the empty scene.
    std::map<std::pair<std::int64_t, std::size_t>, PixelBox> boxes;
    for (const TrackBox& one : seen.track_boxes) {
        if (one.track >= events.size() || !events[one.track]) continue;
        const events::Event& event = seen.events->events[*events[one.track]];
        if (one.frame < event.first.frame || one.frame > event.last.frame) continue;
        const auto [at, is_new] = boxes.try_emplace({one.frame, *events[one.track]}, one.box);
        if (!is_new) at->second = bounding_box(at->second, one.box);
    }
    // The fields don't show an object that the empty scene has, so its track ends before it lies there.
    for (std::size_t k = 0; k < seen.events->events.size(); ++k) {
        const events::Event& event = seen.events->events[k];
        if (!event.in_scene) continue;
        for (std::int64_t frame = event.first.frame; frame <= event.last.frame; ++frame) {
            boxes.try_emplace({frame, k}, event.in_scene->box);
        }
    }
    const VideoScale scale(plan.clip.field_size, seen.info.size);
    std::string text;
    for (const auto& [place, field_box] : boxes) {
        const PixelBox box = scale(field_box);
        text += fmt::format("{},{},{},{},{},{},1,-1,-1,-1\n", place.first + 1, seen.events->numbers[place.second],
                            box.left + 1, box.top + 1, box.width(), box.height());
    }
    return text;
}

}  // namespace vvr::app
