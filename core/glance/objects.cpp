#include "core/glance/objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

#include <fmt/format.h>

namespace vvr::glance {

namespace {

double seconds_of(const events::Event& event) {
    return event.last.seconds - event.first.seconds;
}

double seconds_of(const events::Stay& stay) {
    return stay.last.seconds - stay.first.seconds;
}

/// Importance to a reader, in seconds.
double weight_of(const events::Event& event) {
    constexpr double stay_weight = 3;
    const events::Stay* const stay = longest_stay(event);
    return seconds_of(event) + (stay != nullptr ? stay_weight * seconds_of(*stay) : 0);
}

/// The direction from the first to the last position in the frame.
std::vector<std::string> direction_texts(const events::Event& event) {
    if (event.path.empty()) return {std::string(events::name_of(event.kind))};
    const glm::dvec2 way = event.path.back().place - event.path.front().place;
    if (glm::length(way) < 0.2 * event.path_length) return {"to and fro", "⇄"};
    constexpr std::array<std::string_view, 8> arrows{"→", "↘", "↓", "↙", "←", "↖", "↑", "↗"};
    const double eighths = std::atan2(way.y, way.x) / (2 * std::numbers::pi) * 8;
    const std::string_view arrow = arrows[static_cast<std::size_t>(std::lround(eighths) + 8) % 8];
    return {fmt::format("went {}", arrow), std::string(arrow)};
}

}  // namespace

std::vector<std::size_t> by_importance(std::span<const events::Event> events) {
    std::vector<std::size_t> order(events.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t k) {
        return std::tuple(!row_of(events[k].kind).is_thing, -weight_of(events[k]), k);
    };
    std::ranges::sort(order, {}, key);
    return order;
}

const events::Stay* longest_stay(const events::Event& event) {
    const auto longest =
        std::ranges::max_element(event.stays, {}, [](const events::Stay& stay) { return seconds_of(stay); });
    return longest == event.stays.end() ? nullptr : &*longest;
}

glm::dvec2 position_at(const events::Event& event, double seconds) {
    const std::vector<events::PathPoint>& path = event.path;
    if (path.empty())
        return {(event.box.left + event.box.right - 1) / 2.0, (event.box.top + event.box.bottom - 1) / 2.0};
    const auto after =
        std::ranges::lower_bound(path, seconds, {}, [](const events::PathPoint& p) { return p.at.seconds; });
    if (after == path.begin()) return path.front().place;
    if (after == path.end()) return path.back().place;
    const events::PathPoint& before = *(after - 1);
    const double length = after->at.seconds - before.at.seconds;
    const double share = length > 0 ? (seconds - before.at.seconds) / length : 0;
    return glm::mix(before.place, after->place, share);
}

std::vector<std::string> activity_texts(const events::Event& event) {
    const events::EventKindRow& row = row_of(event.kind);
    const events::Stay* const stay = longest_stay(event);
    const bool has_duration = row.activity.find("{}") != std::string_view::npos;
    if (row.activity.empty() || (has_duration && stay == nullptr)) return direction_texts(event);
    const std::string duration = has_duration ? labels::format_duration(seconds_of(*stay)) : std::string();
    return {fmt::format(fmt::runtime(row.activity), duration), std::string(row.activity_short)};
}

std::vector<events::Stay> stationary_times(const events::Event& event) {
    if (!row_of(event.kind).lies) return event.stays;
    const events::Stay* const stay = longest_stay(event);
    events::Stay whole = stay != nullptr ? *stay : events::Stay{};
    whole.first = event.first;
    whole.last = event.last;
    return {whole};
}

std::vector<std::string> time_texts(const events::Event& event, const WallClock& clock) {
    const std::string begin = labels::format_moment(event.first.seconds, clock);
    return {fmt::format("{}–{}", begin, labels::format_moment(event.last.seconds, clock)), begin};
}

}  // namespace vvr::glance
