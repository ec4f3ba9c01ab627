#include "core/annotation/objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <tuple>

#include <fmt/format.h>

#include "core/tracking/path.h"

namespace vvr::annotation {

namespace {

double seconds_of(const tracking::Event& event) {
    return event.last.seconds - event.first.seconds;
}

double seconds_of(const tracking::Stay& stay) {
    return stay.last.seconds - stay.first.seconds;
}

/// Importance to a reader, in seconds.
double weight_of(const tracking::Event& event) {
    constexpr double stay_weight = 3;
    const tracking::Stay* const stay = longest_stay(event);
    return seconds_of(event) + (stay != nullptr ? stay_weight * seconds_of(*stay) : 0);
}

/// The area of an object at its best moment, field pixels; 0 = unknown.
std::int64_t area_of(const tracking::Event& event) {
    if (!event.portrait) return 0;
    return std::int64_t{event.portrait->box.width()} * event.portrait->box.height();
}

/// The direction from the first to the last position in the frame.
std::vector<std::string> direction_texts(const tracking::Event& event) {
    // In a window over a stream, hardly anything of its path may be left.
    if (event.path.size() < 2 || !(tracking::length_of(event.path) > 0))
        return {std::string(tracking::name_of(event.kind))};
    const tracking::Heading& heading = tracking::heading_of(event.path, event.path_length);
    const std::string words(heading.words);
    const std::string arrow(heading.arrow);
    if (&heading == &tracking::to_and_fro) return {words, arrow};
    return {"went " + words, words, arrow};
}

}  // namespace

std::vector<std::size_t> by_importance(std::span<const tracking::Event> events) {
    std::vector<std::size_t> order(events.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t k) {
        return std::tuple(!row_of(events[k].kind).is_thing, -weight_of(events[k]), k);
    };
    std::ranges::sort(order, {}, key);
    const auto is_thing = [&](std::size_t k) { return row_of(events[k].kind).is_thing; };
    const auto others = std::ranges::find_if_not(order, is_thing);
    if (others == order.end()) return order;
    const auto promote = [&](auto from) {
        constexpr std::ptrdiff_t most_things = 3;
        const auto to = order.begin() + std::min(most_things, others - order.begin());
        std::rotate(to, from, from + 1);
    };
    const auto largest =
        std::ranges::max_element(others, order.end(), {}, [&](std::size_t k) { return area_of(events[k]); });
    const bool is_known = area_of(events[*largest]) > 0;
    const std::size_t slowest = *others;
    if (is_known) promote(largest);
    promote(std::ranges::find(order, slowest));
    return order;
}

const tracking::Stay* longest_stay(const tracking::Event& event) {
    const auto longest =
        std::ranges::max_element(event.stays, {}, [](const tracking::Stay& stay) { return seconds_of(stay); });
    return longest == event.stays.end() ? nullptr : &*longest;
}

glm::dvec2 position_at(const tracking::Event& event, double seconds) {
    const std::vector<tracking::PathPoint>& path = event.path;
    if (path.empty())
        return {(event.box.left + event.box.right - 1) / 2.0, (event.box.top + event.box.bottom - 1) / 2.0};
    const auto after =
        std::ranges::lower_bound(path, seconds, {}, [](const tracking::PathPoint& p) { return p.at.seconds; });
    if (after == path.begin()) return path.front().place;
    if (after == path.end()) return path.back().place;
    const tracking::PathPoint& before = *(after - 1);
    const double length = after->at.seconds - before.at.seconds;
    const double share = length > 0 ? (seconds - before.at.seconds) / length : 0;
    return glm::mix(before.place, after->place, share);
}

namespace {

std::vector<std::string> activities(const tracking::Event& event) {
    const tracking::EventKindRow& row = row_of(event.kind);
    const bool has_duration = row.activity.find("{}") != std::string_view::npos;
    if (row.activity.empty() || (has_duration && event.stays.empty())) return direction_texts(event);
    const std::string duration =
        has_duration ? annotation::format_duration(tracking::stationary_seconds(event)) : std::string();
    const std::string text = fmt::format(fmt::runtime(row.activity), duration);
    if (has_duration && event.stays.size() > 1) return {text + " in all", text, std::string(row.activity_short)};
    return {text, std::string(row.activity_short)};
}

}  // namespace

std::vector<std::string> activity_texts(const tracking::Event& event) {
    std::vector<std::string> texts = activities(event);
    if (!event.identity) return texts;
    const auto plain = std::ssize(texts);
    for (std::ptrdiff_t k = 0; k < plain; ++k)
        texts.insert(texts.begin() + k,
                     fmt::format("{} · {}", event.identity->what->name, texts[static_cast<std::size_t>(2 * k)]));
    return texts;
}

std::string activity_text(const tracking::Event& event) {
    return activities(event).front();
}

std::vector<tracking::Stay> stationary_times(const tracking::Event& event) {
    if (!row_of(event.kind).lies) return event.stays;
    const tracking::Stay* const stay = longest_stay(event);
    tracking::Stay whole = stay != nullptr ? *stay : tracking::Stay{};
    whole.first = event.first;
    whole.last = event.last;
    return {whole};
}

std::vector<std::string> time_texts(const tracking::Event& event, double end, const WallClock& clock,
                                    std::size_t into) {
    const std::string begin = annotation::format_moment_and_day(event.first.seconds, clock);
    std::string until = annotation::format_moment_and_day(event.last.seconds, clock);
    const std::size_t day = begin.find(' ') + 1;  // the length of the day and the space after it
    if (day > 0 && begin == until) return {begin};
    if (until.starts_with(begin.substr(0, day))) until.erase(0, day);
    // Whether it was fetched is what a reader asks first.
    if (event.kind != tracking::EventKind::left || !event.open_ended) {
        const std::string both = fmt::format("{}–{}", begin, until);
        if (into == 0) return {both, begin};
        return {fmt::format("{}, then with {}", both, into), fmt::format("{} joins {}", both, into), both, begin};
    }
    // At a gap, with the time: after it, nobody looked for the thing.
    const std::string at = event.last.seconds >= end ? "" : " at " + until;
    return {fmt::format("{}, still there{}", begin, at), "from " + begin, begin};
}

bool Trails::has(double seconds) const {
    return volume_.layers() > 0 && seconds >= volume_.layer(0).pts &&
           seconds <= volume_.layer(volume_.layers() - 1).last_pts;
}

glm::dvec3 Trails::point(const tracking::Event& event, double seconds) const {
    const glm::dvec2 place = position_at(event, seconds);
    glm::dvec3 c = volume_.c_of({place.x, place.y, 0});
    c.z = volume_.t_of_seconds(seconds);
    return layout_.p_from_c(c);
}

namespace {

/// Whether the object was occluded at a time: its path has a gap there.
bool was_occluded(const tracking::Event& event, double seconds) {
    constexpr double max_step = 1.5;  // seconds; path points are normally 0.5 s or 1/128 of the path apart
    const auto after =
        std::ranges::upper_bound(event.path, seconds, {}, [](const tracking::PathPoint& p) { return p.at.seconds; });
    if (after == event.path.begin() || after == event.path.end()) return false;
    const double life = event.last.seconds - event.first.seconds;
    return after->at.seconds - (after - 1)->at.seconds > std::max(max_step, life / 32);
}

}  // namespace

std::vector<scene::Glyph> direction_arrows(const Objects& objects, const volume::Volume& volume,
                                           const space::Layout& layout, double length) {
    if (volume.layers() == 0) return {};
    const double begin = volume.layer(0).pts;
    const double end = volume.layer(volume.layers() - 1).last_pts;
    const double whole = end - begin;
    constexpr double arrows_along_arc = 16;
    constexpr std::size_t max_objects = 16;  // more objects would have too many arrows
    const space::Camera camera;
    const Trails trails(volume, layout, camera, {1, 1});
    std::vector<scene::Glyph> arrows;
    const std::vector<std::size_t> order = by_importance(objects.events);
    for (std::size_t i = 0; i < std::min(order.size(), max_objects); ++i) {
        const tracking::Event& event = objects.events[order[i]];
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

void label_numbers(const Objects& objects, const std::set<std::size_t>& numbered, const Trails& trails,
                   const annotation::Sheet& sheet, annotation::Lettering& lettering) {
    constexpr std::size_t max_numbers = 24;  // more numbered trails would be confusing
    std::size_t written = 0;
    const int size = std::max(9, sheet.small - 2);
    for (const std::size_t k : by_importance(objects.events)) {
        if (!numbered.contains(k)) continue;
        const tracking::Event& event = objects.events[k];
        for (const double share : {0.0, 0.04, 0.08, 0.15}) {
            const double at = std::lerp(event.first.seconds, event.last.seconds, share);
            const annotation::Badge badge = annotation::make_badge(fmt::format("{}", objects.numbers[k]),
                                                                   trails.pixel(event, at), size, objects.colour_of(k));
            if (!sheet.between.contains(badge.box) || !lettering.is_free(badge.box)) continue;
            lettering.badges.push_back(badge);
            ++written;
            break;
        }
        if (written == max_numbers) return;
    }
}

namespace {

/// A mark across a trail where a stay begins or ends.
struct StayMark {
    double seconds = 0;
    glm::dvec2 place{};
    PixelBox box;
    image::Rgba colour{};
};

/// The marks of the longest stay of each of the most important objects that stood long enough.
std::vector<StayMark> stay_marks(const Objects& objects, const Trails& trails, const glm::dvec2& half) {
    constexpr std::size_t max_marked = 6;
    constexpr double min_share = 0.05;  // of the longest event; shorter stays are dots on the trail
    double longest = 0;
    for (const tracking::Event& event : objects.events)
        longest = std::max(longest, event.last.seconds - event.first.seconds);
    std::size_t marked = 0;
    std::vector<StayMark> marks;
    for (const std::size_t k : by_importance(objects.events)) {
        const tracking::Event& event = objects.events[k];
        const std::vector<tracking::Stay> stays = stationary_times(event);
        const auto stay = std::ranges::max_element(
            stays, {}, [](const tracking::Stay& s) { return s.last.seconds - s.first.seconds; });
        if (stay == stays.end() || stay->last.seconds - stay->first.seconds < std::max(2.0, min_share * longest))
            continue;
        if (marked++ == max_marked) break;
        for (const double seconds : {stay->first.seconds, stay->last.seconds}) {
            // How long it stayed is not known if the footage ended before. A window may begin after it came.
            const bool is_known = !event.open_ended || seconds < event.last.seconds;
            if (!is_known || !trails.has(seconds)) continue;
            const glm::dvec2 place = trails.pixel(event, seconds);
            const glm::ivec2 low(glm::floor(place - half));
            const glm::ivec2 high(glm::ceil(place + half));
            marks.push_back({seconds, place, {low.x, low.y, high.x, high.y}, objects.colour_of(k)});
        }
    }
    return marks;
}

}  // namespace

void label_stays(const Objects& objects, const Trails& trails, const annotation::Sheet& sheet,
                 const image::Rgba& background, annotation::Lettering& lettering) {
    const double width = sheet.small / 6.5;
    const glm::dvec2 up(0, sheet.small * 0.9);
    const std::vector<StayMark> marks = stay_marks(objects, trails, {width, up.y});
    for (const StayMark& mark : marks) {
        lettering.strokes.push_back({mark.place - up, mark.place + up, 1.8 * width, background});
        lettering.strokes.push_back({mark.place - up, mark.place + up, width, mark.colour});
    }
    for (const StayMark& mark : marks) {
        const std::string text = annotation::format_moment_and_day(mark.seconds, objects.clock);
        const auto label_at = [&](const glm::dvec2& lines) {
            const glm::dvec2 at = mark.place + lines * static_cast<double>(sheet.small);
            annotation::Label label = annotation::make_centred_label(text, sheet.small, at.x, at.y, mark.colour);
            label.halo = background;
            return label;
        };
        // On another mark, it would be read as that mark's time.
        const auto is_clear = [&](const annotation::Label& label) {
            return std::ranges::none_of(marks, [&](const StayMark& other) { return other.box.intersects(label.box); });
        };
        for (const glm::dvec2& lines : {glm::dvec2(0, -1.7), glm::dvec2(0, 1.7), glm::dvec2(-2, 0), glm::dvec2(2, 0)}) {
            const annotation::Label label = label_at(lines);
            if (is_clear(label) && lettering.add(label, sheet.between, 1)) break;
        }
    }
}

}  // namespace vvr::annotation
