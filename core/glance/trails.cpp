#include "core/glance/trails.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vvr::glance {

glm::dvec3 Trails::point(const events::Event& event, double seconds) const {
    const glm::dvec2 place = position_at(event, seconds);
    glm::dvec3 c = volume_.c_of({place.x, place.y, 0});
    c.z = volume_.t_of_seconds(seconds);
    return layout_.p_from_c(c);
}

PixelBox map_box(const space::Layout& layout, const space::Camera& camera, Size picture, const PixelBox& area,
                 double aspect) {
    constexpr int samples = 128;
    const double middle = (area.left + area.right) / 2.0;
    // A point of the volume's surface in the picture.
    struct SurfacePoint {
        double from_middle;  ///< horizontal distance from the middle of `area`, pixels
        double row;
    };
    std::vector<SurfacePoint> surface;
    double lowest_of_arc = 0;
    for (int i = 0; i <= samples; ++i) {
        const double t = static_cast<double>(i) / samples;
        for (const double x : {0.0, 0.5, 1.0}) {
            for (const double y : {0.0, 1.0}) {
                const glm::dvec2 at = camera.pixel(layout.p_from_c({x, y, t}), picture);
                surface.push_back({std::abs(at.x - middle), at.y});
                if (i == samples / 2) lowest_of_arc = std::max(lowest_of_arc, at.y);
            }
        }
    }
    if (area.empty()) return {};
    const double gap = picture.height * 0.012;
    PixelBox best;
    for (int half = 20; half < area.width() / 2; half += 2) {
        double top = lowest_of_arc;
        for (const SurfacePoint& at : surface) {
            if (at.from_middle < half + gap) top = std::max(top, at.row);
        }
        const int height = static_cast<int>(2 * half / aspect);
        const int first = static_cast<int>(std::ceil(top + gap));
        if (first + height + gap > area.bottom) break;
        best = {static_cast<int>(middle) - half, first, static_cast<int>(middle) + half, first + height};
    }
    return best;
}

namespace {

// More objects would have too many arrows.
constexpr std::size_t max_objects = 16;

/// Whether the object was occluded at a time: its path has a gap there.
bool was_occluded(const events::Event& event, double seconds) {
    constexpr double max_step = 1.5;  // seconds; path points are normally 0.5 s or 1/128 of the path apart
    const auto after =
        std::ranges::upper_bound(event.path, seconds, {}, [](const events::PathPoint& p) { return p.at.seconds; });
    if (after == event.path.begin() || after == event.path.end()) return false;
    const double life = event.last.seconds - event.first.seconds;
    return after->at.seconds - (after - 1)->at.seconds > std::max(max_step, life / 32);
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
    for (std::size_t i = 0; i < std::min(order.size(), max_objects); ++i) {
        const events::Event& event = objects.events[order[i]];
        const double first = std::max(begin, event.first.seconds);
        const double last = std::min(end, event.last.seconds);
        const double life = last - first;
        if (!(life > 0)) continue;
        const double room =
            volume.is_nonuniform() ? volume.t_of_seconds(last) - volume.t_of_seconds(first) : life / whole;
        // Seconds between an object's arrows. Each arrow shows the motion from `reach` before to `reach` after its
        // time.
        const double each = std::max(life / std::max(room * arrows_along_arc, 1e-9), 0.5);
        const double reach = each / 5;
        const int count = std::max(1, static_cast<int>(life / each));
        for (int k = 0; k < count; ++k) {
            const double at = first + life * (k + 0.5) / count;
            const double from = std::max(first, at - reach);
            const double to = std::min(last, at + reach);
            const glm::dvec2 moved = position_at(event, to) - position_at(event, from);
            // Smaller motions count as stationary.
            if (was_occluded(event, at) || !(to > from) || glm::length(moved) < 0.01 * volume.size().width) continue;
            const glm::dvec3 direction = trails.point(event, to) - trails.point(event, from);
            if (!(glm::length(direction) > 0)) continue;
            const glm::dvec3 vector = glm::normalize(direction) * length;
            const double frames = (to - from) / std::max(whole, 1e-9) * static_cast<double>(volume.frames());
            arrows.push_back({glm::vec3(trails.point(event, at) - vector * 0.5), glm::vec3(vector),
                              static_cast<float>(glm::length(moved) / std::max(frames, 1.0)),
                              static_cast<float>(volume.t_of_seconds(at) * static_cast<double>(volume.frames()))});
        }
    }
    return arrows;
}

}  // namespace vvr::glance
