#include "core/tracking/tracklet.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/tracking/association.h"
#include "core/tracking/path.h"

namespace vvr::tracking {

namespace {

/// A possible link.
struct Link {
    std::size_t earlier;
    std::size_t later;
    double cost;
};
using Links = std::vector<Link>;

Links links_of(std::span<const Tracklet> tracklets) {
    std::vector<std::size_t> order(tracklets.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto begin_of = [&](std::size_t k) { return tracklets[k].begin.at.seconds; };
    std::ranges::stable_sort(order, {}, begin_of);
    Links links;
    for (std::size_t earlier = 0; earlier < tracklets.size(); ++earlier) {
        const double end = tracklets[earlier].end.at.seconds;
        const double latest = end + std::max(thresholds.memory, thresholds.link.seconds);
        auto place = std::ranges::lower_bound(order, end, {}, begin_of);
        for (; place != order.end() && begin_of(*place) <= latest; ++place) {
            if (*place == earlier) continue;
            const double cost = link_cost(tracklets[earlier], tracklets[*place]);
            if (cost < 1) links.push_back({earlier, *place, cost});
        }
    }
    return links;
}

/// Splits links into groups without a common tracklet, which can be solved separately.
std::vector<Links> groups_of(const Links& links, std::size_t tracklets) {
    // A tracklet has two nodes: its end (index k) and its beginning (index tracklets + k).
    std::vector<std::size_t> parent(2 * tracklets);
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t k) {
        while (parent[k] != k) k = parent[k] = parent[parent[k]];
        return k;
    };
    for (const Link& c : links) parent[root(c.earlier)] = root(tracklets + c.later);
    std::map<std::size_t, Links> groups;
    for (const Link& c : links) groups[root(c.earlier)].push_back(c);
    std::vector<Links> result;
    for (auto& [number, group] : groups) result.push_back(std::move(group));
    return result;
}

}  // namespace

double link_cost(const Tracklet& earlier, const Tracklet& later) {
    if (earlier.stretch != later.stretch) return never;
    const double gap = later.begin.at.seconds - earlier.end.at.seconds;
    if (gap < 0 || later.begin.at.frame <= earlier.begin.at.frame) return never;
    const double difference = distance(earlier.appearance, later.appearance) / thresholds.link.looks;
    if (earlier.stood_from_start || later.stood_from_start) {
        // A thing stays in its place. No path begins with a thing.
        const bool both = earlier.stood_to_end && later.stood_from_start;
        const double off =
            glm::distance(earlier.end.place, later.begin.place) / std::max(thresholds.least_length, later.length);
        return both && off < thresholds.stationary.apart && gap <= thresholds.link.seconds ? off : never;
    }
    if (difference > 1) return never;
    const bool same_group = earlier.into && (later.from == earlier.into);
    if (same_group && gap < thresholds.memory) return difference / 3;
    if (gap > thresholds.link.seconds) return never;
    if (earlier.end.at_border || later.begin.at_border) return never;  // nothing occludes at the border
    const double length = std::max({thresholds.least_length, earlier.length, later.length});
    const glm::dvec2 forth = earlier.end.place + gap * earlier.end.velocity;
    const glm::dvec2 back = later.begin.place - gap * later.begin.velocity;
    const double away = std::min(glm::distance(forth, later.begin.place), glm::distance(earlier.end.place, back));
    const double speed = std::max(glm::length(earlier.end.velocity), glm::length(later.begin.velocity));
    const double reach = thresholds.link.reach * length + speed * gap;
    if (away > reach) return never;
    return (away / reach + gap / thresholds.link.seconds + difference) / 3;
}

std::vector<std::optional<std::size_t>> link(std::span<const Tracklet> tracklets) {
    std::vector<std::optional<std::size_t>> next(tracklets.size());
    for (const Links& group : groups_of(links_of(tracklets), tracklets.size())) {
        // A group has few rows and columns, however long the clip is.
        std::map<std::size_t, int> rows;
        std::map<std::size_t, int> columns;
        for (const Link& c : group) {
            rows.try_emplace(c.earlier, static_cast<int>(rows.size()));
            columns.try_emplace(c.later, static_cast<int>(columns.size()));
        }
        Plane<double> costs({static_cast<int>(columns.size()), static_cast<int>(rows.size())}, never);
        for (const Link& c : group) costs.at(columns[c.later], rows[c.earlier]) = c.cost;
        std::vector<std::size_t> place_of(columns.size());
        for (const auto& [later, column] : columns) place_of[static_cast<std::size_t>(column)] = later;
        const auto chosen = assign(costs, 1);
        for (const auto& [earlier, row] : rows) {
            const auto& column = chosen[static_cast<std::size_t>(row)];
            if (column) next[earlier] = place_of[static_cast<std::size_t>(*column)];
        }
    }
    return next;
}

namespace {

void append(const Tracklet& later, Tracklet& whole) {
    const double first_part = whole.seconds();
    const double later_part = later.seconds();
    const double all = std::max(1e-6, first_part + later_part);
    const auto mean = [&](double a, double b) { return (a * first_part + b * later_part) / all; };
    whole.seen = mean(whole.seen, later.seen);
    whole.continuous = mean(whole.continuous, later.continuous);
    whole.area = mean(whole.area, later.area);
    whole.length = mean(whole.length, later.length);
    whole.size = glm::max(whole.size, later.size);
    const auto both = static_cast<double>(whole.differences + later.differences);
    const double weight = both > 0 ? later.differences / both : 0;
    whole.difference.novelty = std::max(whole.difference.novelty, later.difference.novelty);
    whole.difference.texture += weight * (later.difference.texture - whole.difference.texture);
    whole.differences += later.differences;
    whole.moved = std::max({whole.moved, later.moved, glm::distance(whole.begin.place, later.end.place)});
    whole.box = bounding_box(whole.box, later.box);
    while (!whole.path.empty() && whole.path.back().at.frame >= later.path.front().at.frame) {
        whole.path.pop_back();
        whole.areas.pop_back();
    }
    whole.path.insert(whole.path.end(), later.path.begin(), later.path.end());
    whole.areas.insert(whole.areas.end(), later.areas.begin(), later.areas.end());
    whole.stays.insert(whole.stays.end(), later.stays.begin(), later.stays.end());
    if (later.settled) whole.settled = later.settled;
    whole.stood_from_start = whole.stood_from_start && later.stood_from_start;
    if (later.portrait && (!whole.portrait || later.portrait->score > whole.portrait->score)) {
        whole.portrait = later.portrait;
    }
    whole.into = later.into;
    whole.end = later.end;
}

/// If two objects enter as one blob and split, the one with the new number also gets the path before the split.
void begin_with_group(std::size_t k, Trajectories& trajectories) {
    constexpr auto& group = thresholds.group;
    Tracklet& tracklet = trajectories.all[k].whole;
    if (!tracklet.from || tracklet.area_of_parent <= 0 || tracklet.stood_from_start ||
        tracklet.seconds() < 2 * thresholds.event.least) {
        return;
    }
    const double times = tracklet.area_of_parent / std::max(1.0, tracklet.area);
    if (times < group.least || times > group.most) return;
    const auto found = trajectories.of_track.find(*tracklet.from);
    if (found == trajectories.of_track.end() || found->second == k) return;
    const Tracklet& other = trajectories.all[found->second].whole;
    std::vector<PathPoint> before;
    for (std::size_t p = 0; p < other.path.size(); ++p) {
        if (other.path[p].at.frame >= tracklet.begin.at.frame) break;
        before.push_back(other.path[p]);
        if (other.areas[p] > 0 && other.areas[p] < thresholds.most * tracklet.area_of_parent) before.clear();
    }
    if (before.empty() || before.front().at.seconds - other.begin.at.seconds > thresholds.stationary.stay) return;
    tracklet.path.insert(tracklet.path.begin(), before.begin(), before.end());
    tracklet.areas.insert(tracklet.areas.begin(), before.size(), 0);
    tracklet.begin.at = before.front().at;
    tracklet.begin.place = before.front().place;
    tracklet.from.reset();
    tracklet.moved = std::max(tracklet.moved, glm::distance(tracklet.begin.place, tracklet.end.place));
}

/// Whether `part` is where `whole` went. Somebody who stands for long is often seen as two: what is still, and what
/// moves. What was still doesn't go anywhere by itself: it vanishes when the other part goes.
bool leaves_with(const Tracklet& part, const Tracklet& whole) {
    // Nobody saw it come: a thing, unless what came out of it stands as well and is as large, as a car that shunts.
    const double larger = std::max(part.area, whole.area);
    const bool is_same = part.stood_from_start && std::min(part.area, whole.area) >= thresholds.most * larger;
    const bool is_thing = whole.stood_from_start && !is_same;
    if (!whole.stood_to_end || is_thing || part.stretch != whole.stretch || part.path.empty()) {
        return false;
    }
    const double gone = whole.end.at.seconds;
    if (part.begin.at.seconds >= gone || part.end.at.seconds <= gone) return false;
    const double away = glm::distance(place_at(part.path, whole.end.at.frame), whole.end.place);
    return away < thresholds.link.reach * std::max({thresholds.least_length, part.length, whole.length});
}

/// Joins both parts of one object, whose times overlap.
void add_departure(Tracklet part, Tracklet& whole) {
    const std::int64_t gone = whole.end.at.frame;
    std::size_t first = 0;
    while (first + 1 < part.path.size() && part.path[first].at.frame <= gone) ++first;
    part.path.erase(part.path.begin(), part.path.begin() + static_cast<std::ptrdiff_t>(first));
    part.areas.erase(part.areas.begin(), part.areas.begin() + static_cast<std::ptrdiff_t>(first));
    std::erase_if(part.stays, [&](const Stay& stay) { return stay.first.frame <= gone; });
    const double area = std::max(part.area, whole.area);
    append(part, whole);
    whole.area = area;
    whole.stood_to_end = part.stood_to_end;
    whole.gone = part.gone;
}

/// Joins the parts of objects that stood.
void join_parts(std::vector<Trajectory>& all) {
    std::map<std::size_t, std::size_t> of_track;
    for (std::size_t k = 0; k < all.size(); ++k) {
        for (const std::size_t track : all[k].tracks) of_track[track] = k;
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto parent = all[k].whole.from ? of_track.find(*all[k].whole.from) : of_track.end();
        if (parent == of_track.end() || parent->second == k) continue;
        Trajectory& whole = all[parent->second];
        if (whole.tracks.empty() || !leaves_with(all[k].whole, whole.whole)) continue;
        add_departure(std::move(all[k].whole), whole.whole);
        for (const std::size_t track : all[k].tracks) of_track[track] = parent->second;
        whole.tracks.insert(whole.tracks.end(), all[k].tracks.begin(), all[k].tracks.end());
        all[k].tracks.clear();
    }
    std::erase_if(all, [](const Trajectory& trajectory) { return trajectory.tracks.empty(); });
}

}  // namespace

Trajectories join(std::vector<Tracklet> tracklets) {
    std::ranges::stable_sort(tracklets, {}, [](const Tracklet& t) { return std::pair(t.begin.at.frame, t.number); });
    const auto next = link(tracklets);
    std::vector<bool> follows(tracklets.size());
    for (const auto& n : next) {
        if (n) follows[*n] = true;
    }
    Trajectories trajectories;
    for (std::size_t k = 0; k < tracklets.size(); ++k) {
        if (follows[k]) continue;
        Trajectory trajectory{{tracklets[k].number}, tracklets[k]};
        for (auto n = next[k]; n; n = next[*n]) {
            trajectory.tracks.push_back(tracklets[*n].number);
            append(tracklets[*n], trajectory.whole);
        }
        trajectories.all.push_back(std::move(trajectory));
    }
    join_parts(trajectories.all);
    for (std::size_t k = 0; k < trajectories.all.size(); ++k) {
        for (const std::size_t track : trajectories.all[k].tracks) trajectories.of_track[track] = k;
    }
    for (std::size_t k = 0; k < trajectories.all.size(); ++k) begin_with_group(k, trajectories);
    return trajectories;
}

std::optional<PixelBox> box_at(const Tracklet& object, double seconds, std::int64_t frame) {
    for (const Stay& stay : object.stays) {
        if (seconds >= stay.first.seconds && seconds <= stay.last.seconds) return stay.box;
    }
    if (frame < object.begin.at.frame || frame > object.end.at.frame || object.path.empty()) return std::nullopt;
    const glm::ivec2 place(glm::round(place_at(object.path, frame)));
    const glm::ivec2 half(glm::ceil(0.5 * object.size));
    return PixelBox{place.x - half.x, place.y - half.y, place.x + half.x, place.y + half.y};
}

bool is_fragment_of(const Tracklet& piece, const Tracklet& whole) {
    constexpr int samples = 12;
    int inside = 0;
    for (int n = 0; n < samples; ++n) {
        const double part = (n + 0.5) / samples;
        const double seconds = piece.begin.at.seconds + part * piece.seconds();
        const auto frames = static_cast<double>(piece.end.at.frame - piece.begin.at.frame);
        const std::int64_t frame = piece.begin.at.frame + std::llround(part * frames);
        const std::optional<PixelBox> own = box_at(piece, seconds, frame);
        const std::optional<PixelBox> other = box_at(whole, seconds, frame);
        if (!own || !other) continue;
        const PixelBox near = other->inflated(1 + other->width() / 8, 1 + other->height() / 8);
        if (is_mostly_inside(*own, near)) ++inside;
    }
    return inside >= thresholds.most * samples;
}

bool is_near(const std::optional<PixelBox>& box, const PixelBox& place) {
    return box && box->inflated(1 + box->width(), 1 + box->height() / 2).intersects(place);
}

bool was_beside(const Tracklet& bearer, const Tracklet& thing, double seconds_per_frame) {
    constexpr int samples = 8;
    const PixelBox& place = thing.settled->patch.box;
    for (int n = 0; n <= samples; ++n) {
        const double seconds = thing.begin.at.seconds + 0.5 - n * (0.5 + thresholds.bearer) / samples;
        const double frames = (seconds - thing.begin.at.seconds) / seconds_per_frame;
        const std::optional<PixelBox> box = box_at(bearer, seconds, thing.begin.at.frame + std::llround(frames));
        if (is_near(box, place)) return true;
    }
    return false;
}

bool can_carry(const Tracklet& bearer, const Tracklet& thing, EventKind kind, Size field) {
    const TrackEnd& end = kind == EventKind::taken ? bearer.begin : bearer.end;
    const PixelBox& place = thing.settled->patch.box;
    if (end.at_border && !touches_border(place, field)) return true;
    const glm::ivec2 low(glm::floor(end.place - 0.5 * bearer.size));
    const glm::ivec2 high(glm::ceil(end.place + 0.5 * bearer.size));
    const int around = static_cast<int>(std::max(thresholds.least_length, thing.length));
    return !place.inflated(around, around).intersects({low.x, low.y, high.x, high.y});
}

std::optional<Moment> alone_since(const Event& thing, const Event& owner, double length) {
    if (owner.last.seconds < thing.first.seconds) return thing.first;
    std::optional<Moment> since;
    const glm::dvec2 place = thing.path.front().place;
    for (const PathPoint& point : owner.path) {
        if (point.at.seconds < thing.first.seconds || point.at.seconds > thing.last.seconds) continue;
        const bool near = glm::distance(point.place, place) < length;
        if (near) since.reset();
        if (!near && !since) since = point.at;
    }
    if (!since && owner.last.seconds < thing.last.seconds) since = owner.last;
    return since;
}

}  // namespace vvr::tracking
