#include "core/annotation/stills.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/annotation/time_ticks.h"
#include "core/image/picture.h"
#include "core/tracking/patch.h"

namespace vvr::annotation {

void Stills::add(const media::SharedFrame& frame, std::int64_t activity, std::vector<ObjectInStill> objects) {
    if (in_last_ == stretch_) end_stretch();
    if (in_last_ == 0 && kept_.size() == most_) merge_neighbours();
    ++in_last_;
    if (best_ && activity <= best_activity_) return;
    best_ = frame;
    best_activity_ = activity;
    best_objects_ = std::move(objects);
}

void Stills::end_stretch() {
    if (!best_) return;
    kept_.push_back(
        {{best_->index, best_->pts, image::resized(media::picture_of(*best_), size_), std::move(best_objects_)},
         best_activity_});
    best_.reset();
    in_last_ = 0;
}

std::vector<Still> Stills::take() {
    end_stretch();
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

double area(const PixelBox& box) {
    return static_cast<double>(box.width()) * box.height();
}

/// The boxes of events in a still, with the event's index as the track.
std::vector<ObjectInStill> events_in(const Still& still, std::span<const std::optional<std::size_t>> event_of_track,
                                     std::span<const tracking::Event> events) {
    std::vector<ObjectInStill> found;
    for (const auto& [track, box] : still.objects) {
        if (track >= event_of_track.size() || !event_of_track[track]) continue;
        const std::size_t event = *event_of_track[track];
        // A track may begin before its object came.
        if (still.frame < events[event].first.frame || still.frame > events[event].last.frame) continue;
        if (row_of(events[event].kind).is_of_scene) continue;  // only the bare floor is there
        const auto same = std::ranges::find(found, event, &ObjectInStill::track);
        if (same == found.end()) {
            found.push_back({event, box});
            continue;
        }
        // Parts of one object lie side by side; of people who walk apart, the larger one is marked.
        const PixelBox both = bounding_box(same->box, box);
        if (area(both) <= 2 * (area(same->box) + area(box))) {
            same->box = both;
        } else if (area(box) > area(same->box)) {
            same->box = box;
        }
    }
    return found;
}

/// How much changed in a still, field pixels: also what is no event.
double activity(const Still& still) {
    double sum = 0;
    for (const ObjectInStill& object : still.objects) sum += area(object.box);
    return sum;
}

/// How well an object can be seen: its size, less if the border cuts it off.
double visibility(const PixelBox& box, Size field) {
    const bool cut = box.left <= 0 || box.top <= 0 || box.right >= field.width || box.bottom >= field.height;
    return std::sqrt(area(box)) * (cut ? 0.5 : 1);
}

/// A window of the frame's shape around some boxes: four times the smallest of them, so that their surroundings can be
/// recognised, or all of the frame.
PixelBox window_around(std::span<const ObjectInStill> objects, Size field, double aspect) {
    constexpr int surroundings = 4;
    PixelBox all = objects.front().box;
    int side = field.height;
    for (const ObjectInStill& object : objects) {
        all = bounding_box(all, object.box);
        side = std::min(side, std::max(object.box.width(), object.box.height()));
    }
    const double height = std::max({1.0 * surroundings * side, 1.3 * all.height(), 1.3 * all.width() / aspect});
    constexpr double nearly_all = 0.7;
    if (height > nearly_all * field.height || height * aspect > field.width) return {0, 0, field.width, field.height};
    const int rows = static_cast<int>(height);
    const int columns = static_cast<int>(height * aspect);
    const int left = std::clamp((all.left + all.right - columns) / 2, 0, field.width - columns);
    const int top = std::clamp((all.top + all.bottom - rows) / 2, 0, field.height - rows);
    return {left, top, left + columns, top + rows};
}

/// The part of a still's picture that shows a part of the field.
Plane<Bgr> picture_of(const Still& still, const PixelBox& part, Size field, Size size) {
    const double x = static_cast<double>(still.picture.width()) / field.width;
    const double y = static_cast<double>(still.picture.height()) / field.height;
    const PixelBox box{static_cast<int>(part.left * x), static_cast<int>(part.top * y),
                       static_cast<int>(part.right * x), static_cast<int>(part.bottom * y)};
    return image::resized(cropped(still.picture, box), size);
}

/// A frame around an object with its number at the corner.
void mark(const ObjectInStill& object, const ShownStill& shown, const PixelBox& place, const Objects& objects, int size,
          Lettering& lettering) {
    const double scale = static_cast<double>(place.width()) / shown.part.width();
    const auto at = [&](double x, double y) {
        return glm::clamp(
            glm::dvec2(place.left + (x - shown.part.left) * scale, place.top + (y - shown.part.top) * scale),
            glm::dvec2(place.left + 1, place.top + 1), glm::dvec2(place.right - 2, place.bottom - 2));
    };
    const glm::dvec2 low = at(object.box.left - 1, object.box.top - 1);
    const glm::dvec2 high = at(object.box.right + 1, object.box.bottom + 1);
    const image::Rgba colour = objects.colour_of(object.track);
    const double width = std::max(1.0, size / 9.0);
    for (const auto& [wide, ink] : {std::pair{2.5 * width, image::Rgba{1, 1, 1, 1}}, std::pair{1.2 * width, colour}}) {
        lettering.strokes.push_back({low, {high.x, low.y}, wide, ink});
        lettering.strokes.push_back({{high.x, low.y}, high, wide, ink});
        lettering.strokes.push_back({high, {low.x, high.y}, wide, ink});
        lettering.strokes.push_back({{low.x, high.y}, low, wide, ink});
    }
    const std::string number = fmt::format("{}", objects.numbers[object.track]);
    const int letters = size * 3 / 4;
    const double half = make_badge(number, low, letters, colour).size / 2;
    // Above the object if there is room, so that it hides nothing.
    for (const glm::dvec2& wanted :
         {glm::dvec2(low.x + half, low.y - half), glm::dvec2(high.x - half, low.y - half),
          glm::dvec2(low.x + half, high.y + half), glm::dvec2(high.x - half, high.y + half)}) {
        const glm::dvec2 middle = glm::clamp(wanted, glm::dvec2(place.left + half, place.top + half),
                                             glm::dvec2(place.right - half, place.bottom - half));
        const Badge badge = make_badge(number, middle, letters, colour);
        const bool is_hidden =
            std::ranges::any_of(lettering.badges, [&](const Badge& other) { return other.box.intersects(badge.box); });
        if (is_hidden) continue;
        lettering.badges.push_back(badge);
        return;
    }
}

}  // namespace

std::vector<ShownStill> choose_stills(std::span<const Still> stills, std::span<const tracking::Event> events,
                                      Size field, double aspect, std::size_t most) {
    const std::vector<std::optional<std::size_t>> event_of_track = tracking::events_of_tracks(events);
    std::vector<std::vector<ObjectInStill>> found;
    std::vector<double> largest(events.size());
    for (const Still& still : stills) {
        found.push_back(events_in(still, event_of_track, events));
        for (const ObjectInStill& object : found.back())
            largest[object.track] = std::max(largest[object.track], visibility(object.box, field));
    }
    constexpr double again = 0.15;      // worth of an event that was shown, relative to one that was not
    constexpr double little = 0.2;      // worth of a still that shows nothing new
    constexpr double long_time = 0.25;  // of the clip, without a still
    constexpr double notable = 0.1;     // of the largest change
    const auto share_of = [&](const ObjectInStill& object) {  // of its best sight
        return visibility(object.box, field) / std::max(1.0, largest[object.track]);
    };
    std::vector<double> best(events.size());
    std::vector<std::size_t> chosen;
    const auto worth = [&](std::size_t k, bool anew) {
        double sum = 0;
        for (const ObjectInStill& object : found[k]) {
            const double seen = share_of(object);
            sum += std::max(seen - best[object.track], again * seen);
        }
        if (anew && sum < little) return 0.0;
        // Two moments soon after each other look alike.
        const double span = std::max(1e-9, stills.back().seconds - stills.front().seconds);
        for (const std::size_t other : chosen) {
            const double apart = std::abs(stills[k].seconds - stills[other].seconds) / span;
            const double share = apart * static_cast<double>(most) * 1.5;
            if (!anew && share < 1) return 0.0;
            sum *= std::min(1.0, share);
        }
        return sum;
    };
    double busiest = 0;
    for (const Still& still : stills) busiest = std::max(busiest, activity(still));
    // The still that shows most of the longest time without one, far from its ends, if something notable changed then.
    const auto in_longest_gap = [&]() -> std::optional<std::size_t> {
        std::vector<std::size_t> known{0, stills.size() - 1};
        known.insert(known.end(), chosen.begin(), chosen.end());
        std::ranges::sort(known);
        std::optional<std::size_t> next;
        double longest = long_time * (stills.back().seconds - stills.front().seconds);
        for (std::size_t g = 0; g + 1 < known.size(); ++g) {
            const double begin = stills[known[g]].seconds;
            const double end = stills[known[g + 1]].seconds;
            if (end - begin <= longest) continue;
            double most_shown = 0;
            for (std::size_t k = known[g] + 1; k < known[g + 1]; ++k) {
                const double apart = std::min(stills[k].seconds - begin, end - stills[k].seconds);
                const double shown = activity(stills[k]) * apart;
                if (shown <= most_shown || 4 * apart < end - begin || activity(stills[k]) < notable * busiest) continue;
                most_shown = shown;
                longest = end - begin;
                next = k;
            }
        }
        return next;
    };
    std::vector<std::size_t> whole;  // show what no event is
    double most_worth = 0;
    const auto most_telling = [&](bool anew) {
        std::optional<std::size_t> next;
        most_worth = 0;
        for (std::size_t k = 0; k < stills.size(); ++k) {
            if (const double sum = worth(k, anew); sum > most_worth) {
                most_worth = sum;
                next = k;
            }
        }
        return next;
    };
    while (chosen.size() < most && !stills.empty()) {
        std::optional<std::size_t> next = most_telling(true);
        if (!next || (most_worth < 1 && 2 * chosen.size() > most)) {
            if (const std::optional<std::size_t> other = in_longest_gap()) {
                next = other;
                whole.push_back(*other);
            }
        }
        if (!next) next = most_telling(false);
        if (!next) break;
        chosen.push_back(*next);
        for (const ObjectInStill& object : found[*next]) {
            double& known = best[object.track];
            known = std::max(known, share_of(object));
        }
    }
    std::ranges::sort(chosen);
    std::vector<ShownStill> shown;
    for (const std::size_t k : chosen) {
        const bool is_whole = found[k].empty() || std::ranges::find(whole, k) != whole.end();
        const PixelBox part =
            is_whole ? PixelBox{0, 0, field.width, field.height} : window_around(found[k], field, aspect);
        shown.push_back({&stills[k], part, std::move(found[k])});
    }
    return shown;
}

void label_stills(const Objects& objects, std::span<const Still> stills, Size field, const Sheet& sheet,
                  const image::Rgba& pale, const image::Rgba& lines, Lettering& lettering) {
    if (sheet.stills.empty() || stills.empty()) return;
    const Size size = sheet.stills.front().inflated(-1, -1).size();
    const double aspect = static_cast<double>(size.width) / size.height;
    const std::vector<ShownStill> shown = choose_stills(stills, objects.events, field, aspect, sheet.stills.size());
    for (std::size_t k = 0; k < shown.size(); ++k) {
        // Fewer than there is room for lie in the middle.
        const PixelBox& place = sheet.stills[(sheet.stills.size() - shown.size()) / 2 + k];
        lettering.pictures.push_back(
            {place.inflated(-1, -1), picture_of(*shown[k].still, shown[k].part, field, size), lines, 1});
        const Label time = make_label(format_moment_and_day(shown[k].still->seconds, objects.clock), sheet.small,
                                      place.left, place.top - sheet.small / 2, pale);
        lettering.add(time, {place.left, 0, place.right, place.top}, 0);
        for (const ObjectInStill& object : shown[k].marked)
            mark(object, shown[k], place.inflated(-1, -1), objects, sheet.small, lettering);
    }
}

}  // namespace vvr::annotation
