#include "core/events/event_finder.h"

#include <algorithm>
#include <map>
#include <utility>

namespace vvr {

namespace {

constexpr double lost_after = 1;      // seconds for which something may not be seen
constexpr double hidden_after = 2;    // the same within a larger object
constexpr double covered_after = 60;  // the same of something that stands, and has somebody in front of it
constexpr double visible = 0.3;       // part of something that stands
constexpr double undisturbed = 0.8;
constexpr double own_share = 0.2;

}  // namespace

EventFinder::EventFinder(Size field, const EventOptions& options)
    : options_(options),
      field_(field),
      reach_(std::max(1, std::max(field.width, field.height) / 192)),
      min_area_(std::max(4, field.width * field.height / 5000)) {}

void EventFinder::add(const Plane<std::uint8_t>& field, const Moment& now) {
    steadiness_.add(field, now);
    const Blobs blobs = find_blobs(without_standing(field, now), reach_, min_area_);
    Choices choices = choose(blobs);
    share_out(blobs, choices);
    look_after_hidden(field, blobs, choices, now);
    for (auto& chosen : choices) join_pieces(chosen);
    go_on(field, blobs, choices, now);
    settle(now);
    std::erase_if(followed_, [](const Followed& followed) { return followed.over; });
}

/// Takes out of the field what is known to stand there.
Plane<std::uint8_t> EventFinder::without_standing(const Plane<std::uint8_t>& field, const Moment& now) {
    Plane<std::uint8_t> rest = field;
    for (Followed& followed : followed_) {
        Track& track = followed.track;
        if (!track.stands()) continue;
        const double part = track.visible_part(field);
        if (part < visible) continue;
        track.see_standing(now);
        followed.near.reset();
        // Its rim is never quite still. Where somebody is about it, that rim may be theirs.
        const int rim = part >= undisturbed ? reach_ + 1 : 0;
        for_each_pixel(track.patch(), [&](int i, int j, std::uint8_t value) {
            if (rim == 0 && !Steadiness::alike(field.at(i, j), value)) return;
            for (int y = std::max(0, j - rim); y <= std::min(field.height() - 1, j + rim); ++y) {
                for (int x = std::max(0, i - rim); x <= std::min(field.width() - 1, i + rim); ++x) rest.at(x, y) = 0;
            }
        });
    }
    return rest;
}

std::vector<int> EventFinder::overlaps(const Track& track, const Blobs& blobs, const glm::ivec2& by) const {
    std::vector<int> counts(blobs.patches.size());
    for_each_pixel(track.patch(), [&](int i, int j, std::uint8_t) {
        const int x = i + by.x;
        const int y = j + by.y;
        if (x < 0 || x >= blobs.labels.width() || y < 0 || y >= blobs.labels.height()) return;
        if (const int label = blobs.labels.at(x, y)) ++counts[static_cast<std::size_t>(label) - 1];
    });
    return counts;
}

/// Each that moves goes on in the blob that most of it falls on.
EventFinder::Choices EventFinder::choose(const Blobs& blobs) {
    Choices choices(blobs.patches.size());
    overlap_.clear();
    for (std::size_t k = 0; k < followed_.size(); ++k) {
        const Track& track = followed_[k].track;
        overlap_.push_back(overlaps(track, blobs, track.stands() ? glm::ivec2(0) : track.step()));
        if (track.stands() || blobs.patches.empty()) continue;
        if (std::ranges::max(overlap_[k]) == 0) overlap_[k] = overlaps(track, blobs, {0, 0});
        const auto most = std::ranges::max_element(overlap_[k]);
        if (*most > 0) choices[static_cast<std::size_t>(most - overlap_[k].begin())].push_back(k);
    }
    return choices;
}

/// Where several were one and now come apart, each takes a part.
void EventFinder::share_out(const Blobs& blobs, Choices& choices) const {
    for (std::size_t free = 0; free < blobs.patches.size(); ++free) {
        if (!choices[free].empty()) continue;
        double most = own_share;
        std::vector<std::size_t>* crowd = nullptr;
        std::size_t taker = 0;
        for (auto& chosen : choices) {
            if (chosen.size() < 2) continue;
            for (const std::size_t k : chosen) {
                const Track& track = followed_[k].track;
                const double share = static_cast<double>(overlap_[k][free]) / std::max(1, track.patch().area);
                if (!track.was_merged() || share <= most) continue;
                most = share;
                crowd = &chosen;
                taker = k;
            }
        }
        if (crowd == nullptr) continue;
        std::erase(*crowd, taker);
        choices[free].push_back(taker);
    }
}

/// What stood and is not seen now is behind somebody, was taken, or moves itself.
void EventFinder::look_after_hidden(const Plane<std::uint8_t>& field, const Blobs& blobs, Choices& choices,
                                    const Moment& now) {
    for (std::size_t k = 0; k < followed_.size(); ++k) {
        Followed& followed = followed_[k];
        Track& track = followed.track;
        if (followed.over || !track.stands() || track.seen().frame == now.frame) continue;
        if (!followed.near) followed.near = about(track);
        if (!followed.near && rises(k, blobs, choices)) continue;
        int covered = 0;
        for_each_pixel(track.patch(), [&](int i, int j, std::uint8_t) { covered += field.at(i, j) != 0 ? 1 : 0; });
        const bool uncovered = 2 * covered < track.patch().area;
        if (uncovered || now.seconds - track.seen().seconds > covered_after) end(followed, true);
    }
}

/// Where nobody else is near, it goes on in the piece of it that moved off, or in the object that is in its place.
bool EventFinder::rises(std::size_t k, const Blobs& blobs, Choices& choices) {
    const auto is_own = [&](std::size_t other) { return followed_[other].from == followed_[k].track.number(); };
    std::size_t place = choices.size();
    int most = 0;
    for (std::size_t b = 0; b < choices.size(); ++b) {
        const bool own = std::ranges::all_of(choices[b], is_own);
        const int size = choices[b].empty() ? overlap_[k][b] : blobs.patches[b].area;
        if (!own || size <= most) continue;
        most = size;
        place = b;
    }
    if (place == choices.size()) return false;
    for (const std::size_t piece : choices[place]) followed_[piece].over = true;
    followed_[k].track.rise();
    choices[place] = {k};
    return true;
}

/// Who moves beside something that stands.
std::optional<std::size_t> EventFinder::about(const Track& standing) const {
    const PixelBox& box = standing.patch().box;
    const PixelBox wide = box.grown(box.width(), box.height());
    for (const Followed& followed : followed_) {
        const bool own = followed.from == standing.number();
        if (wide.meets(followed.track.patch().box) && !own && !followed.over && !followed.track.stands() &&
            followed.track.is_certain()) {
            return followed.track.number();
        }
    }
    return std::nullopt;
}

/// Pieces that were never seen for long belong to the rest of what they are part of now.
void EventFinder::join_pieces(std::vector<std::size_t>& chosen) {
    if (chosen.size() < 2) return;
    const auto whole = *std::ranges::max_element(chosen, {}, [&](std::size_t k) {
        const Track& track = followed_[k].track;
        return std::pair(track.is_certain(), track.patch().area);
    });
    std::erase_if(chosen, [&](std::size_t k) {
        Followed& piece = followed_[k];
        if (k == whole || piece.track.is_certain()) return false;
        if (!followed_[whole].track.is_certain()) followed_[whole].track.join(piece.track);
        piece.over = true;
        return true;
    });
}

void EventFinder::go_on(const Plane<std::uint8_t>& field, const Blobs& blobs, const Choices& choices,
                        const Moment& now) {
    const std::size_t count = followed_.size();
    std::vector<bool> went_on(count);
    for (std::size_t b = 0; b < blobs.patches.size(); ++b) {
        const auto& chosen = choices[b];
        for (const std::size_t k : chosen) went_on[k] = true;
        if (chosen.size() == 1) {
            followed_[chosen.front()].track.see(blobs.patches[b], now);
            followed_[chosen.front()].near.reset();
            continue;
        }
        for (const std::size_t k : chosen) {
            Followed& followed = followed_[k];
            followed.near = followed_[chosen.front() == k ? chosen.back() : chosen.front()].track.number();
            const bool there = followed.track.see_within(field, now);
            if (!there && now.seconds - followed.track.seen().seconds > hidden_after) end(followed, true);
        }
        if (!chosen.empty()) continue;
        std::optional<std::size_t> from;
        int most = 0;
        for (std::size_t k = 0; k < count; ++k) {
            if (overlap_[k][b] <= most) continue;
            most = overlap_[k][b];
            from = followed_[k].track.number();
        }
        begin(blobs.patches[b], from, now);
    }
    for (std::size_t k = 0; k < count; ++k) {
        Followed& followed = followed_[k];
        if (went_on[k] || followed.over || followed.track.stands()) continue;
        followed.track.miss();
        if (now.seconds - followed.track.seen().seconds > lost_after) end(followed, false);
    }
}

void EventFinder::begin(const Patch& patch, std::optional<std::size_t> from, const Moment& now) {
    followed_.push_back({Track(next_++, patch, now, options_), from, {}, false});
}

void EventFinder::settle(const Moment& now) {
    for (Followed& followed : followed_) {
        Track& track = followed.track;
        const bool alone = !followed.over && !track.stands() && !track.was_merged() && track.seen().frame == now.frame;
        if (alone && track.has_settled(steadiness_, now)) {
            track.settle(steadiness_, now, followed.from && now.seconds - track.first().seconds < 2 * options_.stay);
            join_standing(followed);
        }
    }
}

/// What came to rest in parts, for some of it was hidden for a while, is one thing.
void EventFinder::join_standing(Followed& part) {
    for (Followed& other : followed_) {
        if (&other == &part || other.over || !other.track.stands()) continue;
        if (!part.track.belongs_to(other.track, 2 * reach_ + 1)) continue;
        other.track.add_part(part.track);
        part.over = true;
        return;
    }
}

void EventFinder::end(Followed& followed, bool taken) {
    if (followed.over) return;
    followed.over = true;
    if (!followed.track.is_event()) return;
    Event event = followed.track.finish();
    event.box = {std::max(0, event.box.left), std::max(0, event.box.top), std::min(field_.width, event.box.right),
                 std::min(field_.height, event.box.bottom)};
    ended_.push_back({std::move(event), followed.track.number(), followed.from, taken ? followed.near : std::nullopt});
}

std::vector<Event> EventFinder::finish() {
    for (Followed& followed : followed_) end(followed, false);
    followed_.clear();
    std::ranges::stable_sort(ended_, {},
                             [](const Ended& ended) { return std::pair(ended.event.first.frame, ended.number); });
    std::map<std::size_t, std::size_t> places;
    for (std::size_t k = 0; k < ended_.size(); ++k) places[ended_[k].number] = k;
    const auto place_of = [&](const std::optional<std::size_t>& number) {
        const auto found = number ? places.find(*number) : places.end();
        return found == places.end() ? std::nullopt : std::optional(found->second);
    };
    std::vector<Event> events;
    for (Ended& ended : ended_) {
        ended.event.from = place_of(ended.from);
        ended.event.into = place_of(ended.into);
        events.push_back(std::move(ended.event));
    }
    return events;
}

}  // namespace vvr
