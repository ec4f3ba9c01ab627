#include "core/page/stills.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/glance/objects.h"
#include "core/image/picture.h"

namespace vvr::page {

void Stills::add(std::int64_t frame, double seconds, const Plane<Bgr>& picture, std::int64_t activity) {
    if (kept_.empty() || in_last_ == stretch_) {
        if (kept_.size() == most_) merge_neighbours();
        kept_.push_back({{frame, seconds, image::resized(picture, size_)}, activity});
        in_last_ = 1;
        return;
    }
    ++in_last_;
    Kept& last = kept_.back();
    if (activity > last.activity) last = {{frame, seconds, image::resized(picture, size_)}, activity};
}

std::vector<Still> Stills::take() {
    std::vector<Still> stills;
    stills.reserve(kept_.size());
    for (Kept& kept : kept_) stills.push_back(std::move(kept.still));
    kept_.clear();
    return stills;
}

void Stills::merge_neighbours() {
    for (std::size_t k = 0; k < most_ / 2; ++k) {
        Kept& a = kept_[2 * k];
        Kept& b = kept_[2 * k + 1];
        Kept better = std::move(b.activity > a.activity ? b : a);
        kept_[k] = std::move(better);
    }
    kept_.resize(most_ / 2);
    stretch_ *= 2;
}

namespace {

constexpr Bgr mark{{15, 72, 217}};
constexpr int line = 2;  // pixels

/// A key to rank events; more informative events are greater.
auto worth(const events::Event& event) {
    return std::tuple(-row_of(event.kind).rank, events::stationary_seconds(event),
                      event.last.seconds - event.first.seconds);
}

const Still& nearest_to(std::span<const Still> stills, std::int64_t frame) {
    return *std::ranges::min_element(stills, {}, [frame](const Still& still) { return std::abs(still.frame - frame); });
}

void outline(Plane<Bgr>& picture, const PixelBox& box) {
    const auto inside = [&](int x, int y) {
        return x >= box.left + line && x < box.right - line && y >= box.top + line && y < box.bottom - line;
    };
    for (int y = std::max(0, box.top); y < std::min(box.bottom, picture.size().height); ++y) {
        for (int x = std::max(0, box.left); x < std::min(box.right, picture.size().width); ++x) {
            if (!inside(x, y)) picture.at(x, y) = mark;
        }
    }
}

}  // namespace

std::optional<Still> best_still(std::span<const Still> stills, std::span<const events::Event> events, Size field) {
    if (stills.empty()) return std::nullopt;
    const auto event = std::ranges::max_element(events, {}, worth);
    if (event == events.end() || event->path.empty()) return stills[stills.size() / 2];
    Still still =
        nearest_to(stills, event->portrait ? event->portrait->at.frame : (event->first.frame + event->last.frame) / 2);
    if (still.frame < event->first.frame || still.frame > event->last.frame) return still;
    const double scale = static_cast<double>(still.picture.size().width) / field.width;
    const PixelBox& seen = event->portrait ? event->portrait->box : event->box;
    const glm::dvec2 place = glance::position_at(*event, still.seconds) * scale;
    const double half = std::max(8.0, 0.6 * scale * std::max(seen.width(), seen.height()));
    const auto at = [](double value) { return static_cast<int>(std::lround(value)); };
    outline(still.picture, {at(place.x - half), at(place.y - half), at(place.x + half), at(place.y + half)});
    return still;
}

}  // namespace vvr::page
