#include "core/events/tracklet.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "core/events/association.h"

namespace vvr::events {

namespace {

constexpr double never = 10;
constexpr double overlap = 0.3;            // seconds by which the later may begin before the earlier ends
constexpr double straight_on = 1.0;        // seconds for which a velocity still tells where it goes
constexpr double like_area = 3;            // times by which the areas of one object differ at most
constexpr double unlike = 0.33;            // distance of looks of different people; of one person it is 0.1 to 0.25
constexpr double at_border_seconds = 0.3;  // longest gap of what left the picture, or came in: the border hides nobody
constexpr double same_place = 0.5;     // lengths by which the middle of a thing may be off when it comes to light again
constexpr double hidden_seconds = 60;  // longest gap within a group that both were seen in

/// A link that is possible.
struct Candidate {
    std::size_t earlier;
    std::size_t later;
    double cost;
};
using Candidates = std::vector<Candidate>;

Candidates candidates_of(std::span<const Tracklet> tracklets, const EventOptions& options) {
    std::vector<std::size_t> order(tracklets.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto begin_of = [&](std::size_t k) { return tracklets[k].begin.at.seconds; };
    std::ranges::stable_sort(order, {}, begin_of);
    Candidates candidates;
    for (std::size_t earlier = 0; earlier < tracklets.size(); ++earlier) {
        const double end = tracklets[earlier].end.at.seconds;
        const double latest = end + std::max(hidden_seconds, options.link_seconds);
        auto place = std::ranges::lower_bound(order, end - overlap, {}, begin_of);
        for (; place != order.end() && begin_of(*place) <= latest; ++place) {
            if (*place == earlier) continue;
            const double cost = link_cost(tracklets[earlier], tracklets[*place], options);
            if (cost < options.link_cost) candidates.push_back({earlier, *place, cost});
        }
    }
    return candidates;
}

/// Candidates that share no tracklet with those of another group: each group can be decided on its own.
std::vector<Candidates> groups_of(const Candidates& candidates, std::size_t tracklets) {
    // A tracklet is two nodes: its end, where others follow, and its beginning.
    std::vector<std::size_t> parent(2 * tracklets);
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t k) {
        while (parent[k] != k) k = parent[k] = parent[parent[k]];
        return k;
    };
    for (const Candidate& c : candidates) parent[root(c.earlier)] = root(tracklets + c.later);
    std::map<std::size_t, Candidates> groups;
    for (const Candidate& c : candidates) groups[root(c.earlier)].push_back(c);
    std::vector<Candidates> result;
    for (auto& [number, group] : groups) result.push_back(std::move(group));
    return result;
}

}  // namespace

double link_cost(const Tracklet& earlier, const Tracklet& later, const EventOptions& options) {
    if (earlier.stretch != later.stretch) return never;
    const double gap = later.begin.at.seconds - earlier.end.at.seconds;
    if (gap < -overlap || later.begin.at.frame <= earlier.begin.at.frame) return never;
    const double areas = std::max(earlier.area, later.area) / std::max(1.0, std::min(earlier.area, later.area));
    if (areas > like_area) return never;
    const double looks = distance(earlier.look, later.look) / unlike;
    if (earlier.stood_from_start || later.stood_from_start) {
        // A thing stays where it is; nobody's way begins with it.
        const bool both = earlier.stood_to_end && later.stood_from_start;
        const double off = glm::distance(earlier.end.place, later.begin.place) / std::max(4.0, later.length);
        return both && off < same_place && gap <= options.link_seconds ? off : never;
    }
    if (looks > 1) return never;
    const bool same_group = earlier.into && (later.from == earlier.into);
    if (same_group && gap < hidden_seconds) return 0.8 * looks;
    if (gap > options.link_seconds) return never;
    if ((earlier.end.at_border || later.begin.at_border) && gap > at_border_seconds) return never;
    const double length = std::max({4.0, earlier.length, later.length});
    const double ahead = std::clamp(gap, 0.0, straight_on);
    const glm::dvec2 forth = earlier.end.place + ahead * earlier.end.velocity;
    const glm::dvec2 back = later.begin.place - ahead * later.begin.velocity;
    const double away = std::min(glm::distance(forth, later.begin.place), glm::distance(earlier.end.place, back));
    const double speed = std::max({glm::length(earlier.end.velocity), glm::length(later.begin.velocity), 0.3 * length});
    const double reach = 0.8 * length + 0.7 * speed * std::max(0.0, gap);
    if (away > reach) return never;
    return 0.35 * away / reach + 0.25 * std::max(0.0, gap) / options.link_seconds + 0.6 * looks;
}

std::vector<std::optional<std::size_t>> link(std::span<const Tracklet> tracklets, const EventOptions& options) {
    std::vector<std::optional<std::size_t>> next(tracklets.size());
    for (const Candidates& group : groups_of(candidates_of(tracklets, options), tracklets.size())) {
        // The rows and columns of a group are few, however long the clip is.
        std::map<std::size_t, int> rows;
        std::map<std::size_t, int> columns;
        for (const Candidate& c : group) {
            rows.try_emplace(c.earlier, static_cast<int>(rows.size()));
            columns.try_emplace(c.later, static_cast<int>(columns.size()));
        }
        Plane<double> costs({static_cast<int>(columns.size()), static_cast<int>(rows.size())}, never);
        for (const Candidate& c : group) costs.at(columns[c.later], rows[c.earlier]) = c.cost;
        std::vector<std::size_t> place_of(columns.size());
        for (const auto& [later, column] : columns) place_of[static_cast<std::size_t>(column)] = later;
        const auto chosen = assign(costs, options.link_cost);
        for (const auto& [earlier, row] : rows) {
            const auto& column = chosen[static_cast<std::size_t>(row)];
            if (column) next[earlier] = place_of[static_cast<std::size_t>(*column)];
        }
    }
    return next;
}

}  // namespace vvr::events
