#include "cli/observe/objects.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/scene/theme.h"
#include "core/tracking/event_options.h"
#include "core/tracking/path.h"

namespace vvr::app {

namespace {

constexpr std::size_t most_numbers = 65'535;  // the largest Identity::number
constexpr double stripes = 60;                // per window, dark and light

/// The part of an event that its voxels need.
struct Object {
    int colour = 0;
    std::uint16_t number = 0;
    std::pair<double, double> seen;  ///< seconds
    std::vector<std::pair<double, double>> stays;
};

Object object_of(const tracking::Event& event, int colour, std::size_t place) {
    Object object;
    object.colour = colour;
    object.number = static_cast<std::uint16_t>(place < most_numbers ? place + 1 : 0);
    object.seen = {event.first.seconds, event.last.seconds};
    for (const tracking::Stay& stay : event.stays) object.stays.emplace_back(stay.first.seconds, stay.last.seconds);
    return object;
}

}  // namespace

ShownEvents events_between(std::span<const tracking::Event> events, double begin, double end) {
    ShownEvents shown;
    const std::vector<int> colours = tracking::colours_of(events);
    std::map<std::size_t, std::size_t> places;  // of the shown events
    for (std::size_t k = 0; k < events.size(); ++k) {
        if (events[k].last.seconds < begin || events[k].first.seconds > end) continue;
        places[k] = shown.events.size();
        tracking::Event& event = shown.events.emplace_back(events[k]);
        std::erase_if(event.path, [&](const tracking::PathPoint& point) {
            return point.at.seconds < begin || point.at.seconds > end;
        });
        event.path_length = tracking::length_of(event.path);
        shown.numbers.push_back(k + 1);
        shown.colours.push_back(colours[k]);
    }
    for (tracking::Event& event : shown.events) {
        for (std::optional<std::size_t>* const other : {&event.from, &event.into, &event.by}) {
            const auto place = *other ? places.find(**other) : places.end();
            *other = place == places.end() ? std::nullopt : std::optional(place->second);
        }
    }
    return shown;
}

volume::VoxelStyleLookup objects_of(std::span<const tracking::Event> events, const volume::Volume& volume) {
    const std::vector<int> colours = tracking::colours_of(events);
    std::vector<Object> objects;
    for (std::size_t k = 0; k < events.size(); ++k) objects.push_back(object_of(events[k], colours[k], k));
    const std::int64_t stripe =
        std::max<std::int64_t>(volume.step(), std::llround(static_cast<double>(volume.frames()) / (2 * stripes)));
    return [objects = std::move(objects), events_of = tracking::events_of_tracks(events), stripe](
               std::size_t track, const volume::Layer& layer) {
        if (track >= events_of.size() || !events_of[track]) return volume::VoxelStyle{};
        const Object& object = objects[*events_of[track]];
        const auto is_in = [&](const std::pair<double, double>& span) {
            return layer.last_pts >= span.first && layer.pts <= span.second;
        };
        // The track may begin before the object arrived, when its place differed from the reference. That is not the
        // object.
        if (!is_in(object.seen)) return volume::VoxelStyle{};
        const bool stays = std::ranges::any_of(object.stays, is_in);
        const bool dark = layer.first_frame / stripe % 2 == 0;
        const scene::ObjectState state = !stays ? scene::ObjectState::moving
                                         : dark ? scene::ObjectState::marked
                                                : scene::ObjectState::still;
        return volume::VoxelStyle{scene::palette_index(object.colour, state), object.number};
    };
}

void LiveObjects::see(const tracking::FrameLabels& labels) {
    last_ = labels.at;
    for (const fields::LabelRun& run : labels.runs) {
        const auto [at, is_new] = tracks_.try_emplace(run.track);
        Seen& seen = at->second;
        if (is_new) seen = {labels.at, labels.at, next_colour(), labels.at.frame, false};
        seen.last = labels.at;
        last_seen_[static_cast<std::size_t>(seen.colour)] = labels.at.frame + 1;
    }
}

int LiveObjects::next_colour() const {
    return static_cast<int>(std::ranges::min_element(last_seen_) - last_seen_.begin());
}

void LiveObjects::decide(std::int64_t oldest) {
    std::erase_if(tracks_, [&](const auto& known) { return known.second.last.frame < oldest; });
    std::erase_if(numbers_, [&](const auto& known) { return !tracks_.contains(known.first); });
    for (auto& [track, seen] : tracks_) {
        if (seen.decided) continue;
        seen.decided = seen.last.seconds - seen.first.seconds >= tracking::thresholds.event.least;
        if (!seen.decided) seen.undecided = last_.frame + 1;
    }
}

std::optional<int> LiveObjects::colour_of(std::size_t track) const {
    const auto known = tracks_.find(track);
    return known == tracks_.end() ? std::nullopt : std::optional(known->second.colour);
}

volume::VoxelStyleLookup LiveObjects::identify() const {
    return [this](std::size_t track, const volume::Layer& layer) {
        const auto known = tracks_.find(track);
        if (known == tracks_.end()) return volume::VoxelStyle{};
        const Seen& seen = known->second;
        if (!seen.decided || layer.last_frame < seen.undecided) return volume::VoxelStyle{};
        const auto number = numbers_.find(track);
        const bool fits = number != numbers_.end() && number->second <= most_numbers;
        return volume::VoxelStyle{scene::palette_index(seen.colour, scene::ObjectState::moving),
                                  fits ? static_cast<std::uint16_t>(number->second) : std::uint16_t{0}};
    };
}

void add_boxes(const tracking::FrameLabels& labels, std::vector<TrackBox>& boxes) {
    const auto begin = std::ssize(boxes);
    for (const fields::LabelRun& run : labels.runs) {
        const PixelBox box{run.first, run.row, run.last + 1, run.row + 1};
        const auto of_frame = boxes.begin() + begin;
        const auto known =
            std::find_if(of_frame, boxes.end(), [&](const TrackBox& one) { return one.track == run.track; });
        if (known == boxes.end()) {
            boxes.push_back({labels.at.frame, run.track, box});
        } else {
            known->box = bounding_box(known->box, box);
        }
    }
}

}  // namespace vvr::app
