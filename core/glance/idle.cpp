#include "core/glance/idle.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "core/base/plane.h"
#include "core/events/event_options.h"

namespace vvr::glance {

namespace {

/// Whether something compact in a layer belongs to no object: it fills a quarter of a block of the picture. Leaves,
/// rain and noise are scattered.
bool has_unowned_thing(const bricks::Volume& volume, const bricks::Layer& layer, const bricks::Identify& identify) {
    constexpr int blocks_across = 24;  // along the longer side
    const Size size = volume.size();
    const int side = std::max(4, std::max(size.width, size.height) / blocks_across);
    Plane<int> counts({(size.width + side - 1) / side, (size.height + side - 1) / side});
    std::uint16_t known = 0;  // neighbours mostly have the same owner
    bool known_has_object = false;
    layer.scalar.for_each_run([&](int column, int row, std::span<const std::uint8_t> values) {
        for (const std::uint8_t value : values) {
            const bool has_owner = value != 0 && !layer.owner.empty();
            const std::uint16_t owner = has_owner ? layer.owner.at(column, row) : std::uint16_t{0};
            if (owner != known) {
                known = owner;
                known_has_object = owner != 0 && identify && identify(volume.track_of(owner), layer).look != 0;
            }
            if (value != 0 && !known_has_object) ++counts.at(column / side, row / side);
            ++column;
        }
    });
    return 4 * std::ranges::max(counts.pixels()) >= side * side;
}

}  // namespace

std::vector<Period> idle_periods(std::vector<Period> busy, double begin, double end) {
    std::ranges::sort(busy, {}, &Period::begin);
    std::vector<Period> idle;
    double until = begin;
    for (const Period& period : busy) {
        if (period.begin > until) idle.push_back({until, std::min(period.begin, end)});
        until = std::max(until, period.end);
    }
    if (until < end) idle.push_back({until, end});
    return idle;
}

std::vector<Period> unexplained_periods(const bricks::Volume& volume, const bricks::Identify& identify) {
    std::vector<Period> periods;
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        const bricks::Layer& layer = volume.layer(i);
        if (!has_unowned_thing(volume, layer, identify)) continue;
        const double end = i + 1 < volume.layers() ? volume.layer(i + 1).pts : layer.last_pts;
        if (!periods.empty() && periods.back().end >= layer.pts) {
            periods.back().end = end;
        } else {
            periods.push_back({layer.pts, end});
        }
    }
    std::erase_if(periods,
                  [](const Period& period) { return period.end - period.begin < events::thresholds.event.least; });
    return periods;
}

}  // namespace vvr::glance
