#include "core/tracking/event.h"

#include <algorithm>
#include <array>

#include "core/tracking/event_options.h"

namespace vvr::tracking {

std::vector<std::pair<double, double>> busy_times(std::span<const Event> events) {
    constexpr double lasting = 1;  // seconds for which an object that stops still counts
    std::vector<std::pair<double, double>> times;
    for (const Event& event : events) {
        double begin = event.first.seconds;
        for (const Stay& stay : event.stays) {
            const bool lies = row_of(event.kind).is_thing || stay.last.seconds - stay.first.seconds > thresholds.memory;
            if (!lies || stay.last.seconds - stay.first.seconds <= 2 * lasting) continue;
            times.emplace_back(begin, stay.first.seconds + lasting);
            begin = stay.last.seconds - lasting;
        }
        times.emplace_back(begin, event.last.seconds);
    }
    return times;
}

std::vector<Event> choose_events(std::vector<Event> events, const EventChoice& choice) {
    std::vector<std::optional<std::size_t>> places(events.size());
    std::size_t count = 0;
    for (std::size_t k = 0; k < events.size(); ++k) {
        if (choice.accepts(events[k])) places[k] = count++;
    }
    std::vector<Event> chosen;
    chosen.reserve(count);
    for (std::size_t k = 0; k < events.size(); ++k) {
        if (!places[k]) continue;
        Event& event = chosen.emplace_back(std::move(events[k]));
        for (auto* other : {&event.from, &event.into, &event.by}) {
            if (*other) *other = places[**other];
        }
    }
    return chosen;
}

namespace {

constexpr int cells = 12;  // per side of the picture
constexpr int window = cells / 3;
constexpr int longest = 8;  // picture's longer side / 8: a small event stays within it
constexpr int crowd = 12;   // events; fewer can be read one by one

/// The window's first column and row, in cells.
struct Corner {
    int x = 0;
    int y = 0;
};

int cell_of(int low, int high, int side) {
    return std::clamp((low + high) * cells / (2 * side), 0, cells - 1);
}

Corner cell_of(const PixelBox& box, Size field) {
    return {cell_of(box.left, box.right, field.width), cell_of(box.top, box.bottom, field.height)};
}

bool is_inside(const Corner& cell, const Corner& corner) {
    return cell.x >= corner.x && cell.x < corner.x + window && cell.y >= corner.y && cell.y < corner.y + window;
}

/// The position of the window with the largest sum, and that sum.
/// \param counts one per cell, row by row
std::pair<Corner, std::int64_t> fullest(const std::array<std::int64_t, cells * cells>& counts) {
    std::pair<Corner, std::int64_t> best{{}, -1};
    for (int y = 0; y + window <= cells; ++y) {
        for (int x = 0; x + window <= cells; ++x) {
            std::int64_t sum = 0;
            for (int j = y; j < y + window; ++j) {
                for (int i = x; i < x + window; ++i) sum += counts[static_cast<std::size_t>(j * cells + i)];
            }
            if (sum > best.second) best = {{x, y}, sum};
        }
    }
    return best;
}

}  // namespace

std::optional<Clutter> find_clutter(std::span<const Event> events, Size field) {
    const int most = std::max(field.width, field.height) / longest;
    std::array<std::int64_t, cells * cells> counts{};
    std::vector<const Event*> small;
    for (const Event& event : events) {
        if (event.box.width() > most || event.box.height() > most) continue;
        const Corner cell = cell_of(event.box, field);
        ++counts[static_cast<std::size_t>(cell.y * cells + cell.x)];
        small.push_back(&event);
    }
    const auto [corner, inside] = fullest(counts);
    const std::int64_t count = std::ssize(small);
    if (count < crowd || 2 * count < std::ssize(events) || 2 * inside < count) return std::nullopt;

    std::optional<Clutter> scraps;
    for (const Event* event : small) {
        if (!is_inside(cell_of(event->box, field), corner)) continue;
        if (!scraps) scraps = Clutter{count, event->box, event->portrait ? event->portrait->at : event->first};
        scraps->box = bounding_box(scraps->box, event->box);
    }
    return scraps;
}

double stationary_seconds(const Event& event) {
    double still = 0;
    for (const Stay& stay : event.stays) still += stay.last.seconds - stay.first.seconds;
    return still;
}

}  // namespace vvr::tracking
