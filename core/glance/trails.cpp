#include "core/glance/trails.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vvr::glance {

glm::dvec3 Trails::point(const events::Event& event, double seconds) const {
    const glm::dvec2 place = place_at(event, seconds);
    glm::dvec3 c = volume_.c_of({place.x, place.y, 0});
    c.z = volume_.t_of_seconds(seconds);
    return layout_.p_from_c(c);
}

PixelBox hollow_of(const space::Layout& layout, const space::Camera& camera, Size picture, const PixelBox& area,
                   double aspect) {
    constexpr int samples = 128;
    const double middle = (area.left + area.right) / 2.0;
    // By distance from the middle, down to which row the volume reaches.
    struct Reach {
        double away;
        double row;
    };
    std::vector<Reach> reaches;
    double lowest_of_arc = 0;
    for (int i = 0; i <= samples; ++i) {
        const double t = static_cast<double>(i) / samples;
        for (const double x : {0.0, 0.5, 1.0}) {
            for (const double y : {0.0, 1.0}) {
                const glm::dvec2 at = camera.pixel(layout.p_from_c({x, y, t}), picture);
                reaches.push_back({std::abs(at.x - middle), at.y});
                if (i == samples / 2) lowest_of_arc = std::max(lowest_of_arc, at.y);
            }
        }
    }
    if (area.empty()) return {};
    const double gap = picture.height * 0.012;
    PixelBox best;
    for (int half = 20; half < area.width() / 2; half += 2) {
        double top = lowest_of_arc;
        for (const Reach& reach : reaches) {
            if (reach.away < half + gap) top = std::max(top, reach.row);
        }
        const int height = static_cast<int>(2 * half / aspect);
        const int first = static_cast<int>(std::ceil(top + gap));
        if (first + height + gap > area.bottom) break;
        best = {static_cast<int>(middle) - half, first, static_cast<int>(middle) + half, first + height};
    }
    return best;
}

namespace {

// Of more objects, arrows are a swarm.
constexpr std::size_t most_objects = 16;

/// Whether nobody saw it about a time: its path jumps from before to after.
bool was_hidden(const events::Event& event, double seconds) {
    constexpr double longest_step = 1.5;  // seconds; points of a path are at most half a second apart, or a 128th of it
    const auto after =
        std::ranges::upper_bound(event.path, seconds, {}, [](const events::PathPoint& p) { return p.at.seconds; });
    if (after == event.path.begin() || after == event.path.end()) return false;
    const double life = event.last.seconds - event.first.seconds;
    return after->at.seconds - (after - 1)->at.seconds > std::max(longest_step, life / 32);
}

}  // namespace

std::vector<scene::Glyph> direction_arrows(const Objects& objects, const bricks::Volume& volume,
                                           const space::Layout& layout, double length) {
    if (volume.layers() == 0) return {};
    const double begin = volume.layer(0).pts;
    const double end = volume.layer(volume.layers() - 1).last_pts;
    const double whole = end - begin;
    constexpr double arrows_along_arc = 16;
    const space::Camera camera;
    const Trails trails(volume, layout, camera, {1, 1});
    std::vector<scene::Glyph> arrows;
    const std::vector<std::size_t> order = by_importance(objects.events);
    for (std::size_t i = 0; i < std::min(order.size(), most_objects); ++i) {
        const events::Event& event = objects.events[order[i]];
        const double first = std::max(begin, event.first.seconds);
        const double last = std::min(end, event.last.seconds);
        const double life = last - first;
        if (!(life > 0)) continue;
        const double room =
            volume.is_nonuniform() ? volume.t_of_seconds(last) - volume.t_of_seconds(first) : life / whole;
        // Seconds between two arrows of an object; each shows the motion over a time before and after it.
        const double each = std::max(life / std::max(room * arrows_along_arc, 1e-9), 0.5);
        const double reach = each / 5;
        const int count = std::max(1, static_cast<int>(life / each));
        for (int k = 0; k < count; ++k) {
            const double at = first + life * (k + 0.5) / count;
            const double from = std::max(first, at - reach);
            const double to = std::min(last, at + reach);
            const glm::dvec2 moved = place_at(event, to) - place_at(event, from);
            // What moves less than this in the scene stands, for a reader.
            if (was_hidden(event, at) || !(to > from) || glm::length(moved) < 0.01 * volume.size().width) continue;
            const glm::dvec3 way = trails.point(event, to) - trails.point(event, from);
            if (!(glm::length(way) > 0)) continue;
            const glm::dvec3 vector = glm::normalize(way) * length;
            const double frames = (to - from) / std::max(whole, 1e-9) * static_cast<double>(volume.frames());
            arrows.push_back({glm::vec3(trails.point(event, at) - vector * 0.5), glm::vec3(vector),
                              static_cast<float>(glm::length(moved) / std::max(frames, 1.0)),
                              static_cast<float>(volume.t_of_seconds(at) * static_cast<double>(volume.frames()))});
        }
    }
    return arrows;
}

}  // namespace vvr::glance
