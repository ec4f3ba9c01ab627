#include "core/events/linking.h"

#include <algorithm>

#include "core/events/assignment.h"

namespace vvr {

namespace {

constexpr double never = 10;
constexpr double overlap = 0.3;            // seconds by which the later may begin before the earlier ends
constexpr double straight_on = 1.0;        // seconds for which a velocity still tells where it goes
constexpr double like_area = 3;            // times by which the areas of one object differ at most
constexpr double unlike = 0.33;            // distance of looks of different people; of one person it is 0.1 to 0.25
constexpr double at_border_seconds = 0.3;  // longest gap of what left the picture, or came in: the border hides nobody
constexpr double same_place = 0.5;     // lengths by which the middle of a thing may be off when it comes to light again
constexpr double hidden_seconds = 60;  // longest gap within a group that both were seen in

}  // namespace

double link_cost(const Tracklet& earlier, const Tracklet& later, const EventOptions& options) {
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
    // Only those that end, or begin, where something could follow are rows, or columns: a long stream has many others.
    std::vector<std::size_t> rows;
    std::vector<std::size_t> columns;
    std::vector<std::vector<std::pair<std::size_t, double>>> candidates(tracklets.size());
    std::vector<bool> wanted(tracklets.size());
    for (std::size_t a = 0; a < tracklets.size(); ++a) {
        for (std::size_t b = 0; b < tracklets.size(); ++b) {
            if (a == b) continue;
            const double cost = link_cost(tracklets[a], tracklets[b], options);
            if (cost >= options.link_cost) continue;
            candidates[a].emplace_back(b, cost);
            wanted[b] = true;
        }
        if (!candidates[a].empty()) rows.push_back(a);
    }
    std::vector<int> column_of(tracklets.size(), -1);
    for (std::size_t b = 0; b < tracklets.size(); ++b) {
        if (!wanted[b]) continue;
        column_of[b] = static_cast<int>(columns.size());
        columns.push_back(b);
    }
    Plane<double> costs({static_cast<int>(columns.size()), static_cast<int>(rows.size())}, never);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (const auto& [b, cost] : candidates[rows[r]]) costs.at(column_of[b], static_cast<int>(r)) = cost;
    }
    const auto chosen = assign(costs, options.link_cost);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        if (chosen[r]) next[rows[r]] = columns[static_cast<std::size_t>(*chosen[r])];
    }
    return next;
}

}  // namespace vvr
