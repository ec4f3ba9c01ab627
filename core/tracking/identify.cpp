#include "core/tracking/identify.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>

#include "core/tracking/event_options.h"
#include "core/tracking/path.h"

namespace vvr::tracking {

namespace {

constexpr std::size_t groups = 5;

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
    event.open_ended = false;
}

void refute(Event& event, std::span<const Moment> begins) {
    if (event.evidence) event.evidence->refuted = event.kind;
    if (row_of(event.kind).is_of_scene) move_before_ghost(event, begins);
    event.kind = EventKind::stood;
    event.by.reset();
    event.alone_since.reset();
}

bool counts(const Look& look) {
    return look.what != nullptr && look.score >= thresholds.detector.score;
}

bool is_seen_at(const Event& event, const Moment& at) {
    return at.frame >= event.first.frame && at.frame <= event.last.frame && !event.path.empty();
}

/// Whether each look at an object shows `other` too, in its box, where both are there.
/// \returns nothing where no look tells
std::optional<bool> shows(std::span<const Look> looks, const Event& other) {
    std::optional<bool> all;
    for (const Look& look : looks) {
        if (!counts(look) || !is_seen_at(other, look.at)) continue;
        const glm::ivec2 place(glm::round(place_at(other.path, look.at.frame)));
        all = all.value_or(true) && look.box.intersects({place.x, place.y, place.x + 1, place.y + 1});
    }
    return all;
}

/// Whether the detector sees one object where the fields have two: an event's pictures show the other in the same box,
/// and those of the other, if it is known in them, show the first.
bool is_part_of(const Event& part, std::span<const Look> own, const Event& whole, std::span<const Look> looks) {
    // A bag beside somebody is a thing of its own.
    if (row_of(part.kind).is_thing) return false;
    if (!whole.identity || !detector::lives_or_drives(whole.identity->what->group)) return false;
    if (part.identity && part.identity->what->group != whole.identity->what->group) return false;
    const double begin = std::max(part.first.seconds, whole.first.seconds);
    const double both = std::min(part.last.seconds, whole.last.seconds) - begin;
    if (both < thresholds.most * (part.last.seconds - part.first.seconds)) return false;
    return shows(looks, part).value_or(false) && (!part.identity || shows(own, whole).value_or(false));
}

/// The index of the event of which each is a part; its own where it is whole.
std::vector<std::size_t> wholes_of(std::span<const Event> events, std::span<const std::vector<Look>> looks) {
    std::vector<std::size_t> whole_of(events.size());
    std::iota(whole_of.begin(), whole_of.end(), std::size_t{0});
    const auto seconds_of = [&](std::size_t k) { return events[k].last.seconds - events[k].first.seconds; };
    std::vector<std::size_t> longest = whole_of;
    std::ranges::stable_sort(longest, std::greater{}, seconds_of);
    for (std::size_t n = 0; n < longest.size(); ++n) {
        const std::size_t part = longest[n];
        const auto whole =
            std::find_if(longest.begin(), longest.begin() + static_cast<std::ptrdiff_t>(n), [&](std::size_t k) {
                return whole_of[k] == k && is_part_of(events[part], looks[part], events[k], looks[k]);
            });
        if (whole != longest.begin() + static_cast<std::ptrdiff_t>(n)) whole_of[part] = *whole;
    }
    return whole_of;
}

/// Joins parts of objects to the whole, with their pixels.
void join_parts(std::vector<Event>& events, std::span<const std::vector<Look>> looks) {
    const std::vector<std::size_t> whole_of = wholes_of(events, looks);
    std::vector<std::size_t> places(events.size());
    std::vector<Event> rest;
    for (std::size_t k = 0; k < events.size(); ++k) {
        if (whole_of[k] != k) continue;
        places[k] = rest.size();
        rest.push_back(events[k]);
    }
    for (std::size_t k = 0; k < events.size(); ++k) {
        if (whole_of[k] == k) continue;
        Event& whole = rest[places[k] = places[whole_of[k]]];
        whole.tracks.insert(whole.tracks.end(), events[k].tracks.begin(), events[k].tracks.end());
        whole.box = bounding_box(whole.box, events[k].box);
    }
    for (std::size_t k = 0; k < rest.size(); ++k) {
        for (auto* other : {&rest[k].from, &rest[k].into, &rest[k].by}) {
            if (*other) *other = places[**other] == k ? std::nullopt : std::optional(places[**other]);
        }
    }
    events = std::move(rest);
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
    for (std::size_t k = 0; k < found.events.size(); ++k) found.events[k].identity = identity_of(looks[k]);
    join_parts(found.events, looks);
    for (Event& event : found.events) {
        const bool alive = event.identity && detector::lives_or_drives(event.identity->what->group);
        if (alive && row_of(event.kind).is_thing) refute(event, found.begins);
    }
    sort_by_first(found.events);
}

}  // namespace vvr::tracking
