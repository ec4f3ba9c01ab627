#include "core/tracking/proximity.h"

#include <algorithm>
#include <cmath>

#include "core/tracking/event_options.h"
#include "core/tracking/path.h"

namespace vvr::tracking {

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
