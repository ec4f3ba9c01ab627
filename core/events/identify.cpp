#include "core/events/identify.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>

#include "core/events/event_options.h"

namespace vvr::events {

namespace {

constexpr std::size_t groups = 5;

bool lives_or_drives(detector::Group group) {
    using detector::Group;
    return group == Group::person || group == Group::vehicle || group == Group::animal;
}

/// What the empty scene shows was there until the fields show its ghost, and for all of that stretch.
/// \param begins of the stretches
void move_before_ghost(Event& event, std::span<const Moment> begins) {
    const auto after = std::ranges::upper_bound(begins, event.first.frame, {}, &Moment::frame);
    const Moment begin = after == begins.begin() ? event.first : *(after - 1);
    const PixelBox& box = event.box;
    const glm::dvec2 place = glm::dvec2(box.left + box.right - 1, box.top + box.bottom - 1) / 2.0;
    event.last = event.first;
    event.first = begin;
    event.path = {{event.first, place}, {event.last, place}};
    event.path_length = 0;
    event.stays = {{event.first, event.last, place, box}};
    event.from.reset();
    event.into.reset();
    event.portrait.reset();
}

void refute(Event& event, std::span<const Moment> begins) {
    if (event.evidence) event.evidence->refuted = event.kind;
    if (row_of(event.kind).is_of_scene) move_before_ghost(event, begins);
    event.kind = EventKind::stood;
    event.by.reset();
    event.alone_since.reset();
}

/// Sorts events by their first frames, and renumbers references.
void sort_by_first(std::vector<Event>& events) {
    std::vector<std::size_t> order(events.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return events[k].first.frame; });
    std::vector<std::size_t> places(events.size());
    std::vector<Event> sorted;
    for (const std::size_t k : order) {
        places[k] = sorted.size();
        sorted.push_back(std::move(events[k]));
    }
    for (Event& event : sorted) {
        for (auto* other : {&event.from, &event.into, &event.by}) {
            if (*other) *other = places[**other];
        }
    }
    events = std::move(sorted);
}

}  // namespace

std::optional<Identity> identity_of(std::span<const Look> looks) {
    std::array<double, groups> votes{};
    const auto counts = [](const Look& look) {
        return look.what != nullptr && look.score >= thresholds.detector.score;
    };
    for (const Look& look : looks) {
        if (counts(look)) votes.at(static_cast<std::size_t>(look.what->group)) += look.score;
    }
    const auto most = std::ranges::max_element(votes);
    if (*most == 0) return std::nullopt;
    Identity identity;
    for (const Look& look : looks) {
        if (!counts(look) || static_cast<std::ptrdiff_t>(look.what->group) != most - votes.begin()) continue;
        ++identity.looks;
        if (look.score <= identity.score) continue;
        identity.what = look.what;
        identity.score = look.score;
    }
    return identity;
}

void identify(Findings& found, std::span<const std::vector<Look>> looks) {
    for (std::size_t k = 0; k < std::min(found.events.size(), looks.size()); ++k) {
        Event& event = found.events[k];
        event.identity = identity_of(looks[k]);
        const bool alive = event.identity && lives_or_drives(event.identity->what->group);
        if (alive && row_of(event.kind).is_thing) refute(event, found.begins);
    }
    sort_by_first(found.events);
}

}  // namespace vvr::events
