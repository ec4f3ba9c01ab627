#include "core/glance/portraits.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/glance/portrait_row.h"
#include "core/image/picture.h"

namespace vvr::glance {

namespace {

Plane<Bgr> crop_of(const Plane<Bgr>& from, const PixelBox& box) {
    Plane<Bgr> part(box.size());
    for (int j = 0; j < box.height(); ++j) {
        const auto row = from.row(box.top + j).subspan(static_cast<std::size_t>(box.left), part.row(j).size());
        std::ranges::copy(row, part.row(j).begin());
    }
    return part;
}

}  // namespace

PixelBox still_box(const PixelBox& object, Size frame) {
    constexpr double around = 1.5;  // side of the square / longer side of the object
    constexpr int min_side = 40;    // pixels; smaller stills show no context
    const int longer = std::max(object.width(), object.height());
    const int shorter_of_frame = std::min(frame.width, frame.height);
    const int side = std::min(std::max(min_side, static_cast<int>(longer * around)), shorter_of_frame);
    const int left = std::clamp((object.left + object.right - side) / 2, 0, frame.width - side);
    const int top = std::clamp((object.top + object.bottom - side) / 2, 0, frame.height - side);
    return {left, top, left + side, top + side};
}

void Crops::keep(std::size_t track, const events::Portrait& portrait, const video::Frame& frame) {
    if (frame.colour.empty() && frame.grey.empty()) return;  // data files without pictures
    const Size size = frame.colour.empty() ? frame.grey.size() : frame.colour.size();
    const PixelBox box = still_box(portrait.box, size);
    const Plane<Bgr> part = frame.colour.empty() ? crop_of(video::picture_of(frame), box) : crop_of(frame.colour, box);
    crops_[track] = {portrait.at, portrait.score, portrait.box.translated(-box.left, -box.top), part};
    if (crops_.size() <= max_crops) return;
    crops_.erase(std::ranges::min_element(crops_, {}, [](const auto& entry) { return entry.second.score; }));
}

std::vector<Plane<Bgr>> portraits_of(std::span<const events::Event> events, const Crops& crops) {
    constexpr std::size_t many = 200;
    const int side = events.size() < many ? 72 : 40;
    std::vector<Plane<Bgr>> portraits;
    portraits.reserve(events.size());
    for (const events::Event& event : events) {
        const Crop* const crop = crops.find(event);
        portraits.push_back(crop == nullptr ? Plane<Bgr>() : image::resized(crop->picture, {side, side}));
    }
    return portraits;
}

const Crop* Crops::find(const events::Event& event) const {
    const Crop* best = nullptr;
    for (const std::size_t track : event.tracks) {
        const auto found = crops_.find(track);
        if (found == crops_.end()) continue;
        const Crop& crop = found->second;
        if (event.portrait && crop.at.frame == event.portrait->at.frame) return &crop;
        if (best == nullptr || crop.score > best->score) best = &crop;
    }
    return best;
}

namespace {

// Maximum number of events to try: if lines would cross, less important events take their turn.
constexpr std::size_t max_candidates = 40;
// Maximum number of numbered trails: more would be confusing.
constexpr std::size_t max_numbers = 24;

/// Anchors along the trail; those near the portrait's own time cost least.
std::vector<Anchor> anchors_of(const events::Event& event, double moment, const Trails& trails) {
    constexpr int steps = 24;
    std::vector<Anchor> anchors;
    const double length = event.last.seconds - event.first.seconds;
    for (int i = 0; i <= steps; ++i) {
        const double at = event.first.seconds + length * (0.06 + 0.88 * i / steps);
        const double off = length > 0 ? std::abs(at - moment) / length : 0;
        anchors.push_back({trails.pixel(event, at), 40 * off});
    }
    return anchors;
}

struct Candidate {
    std::size_t event;
    const Crop* crop;
};

/// Marks the corners of the object's bounding box, because a still may show other objects too.
void mark_object(const Crop& crop, const PixelBox& still, const image::Rgba& colour, labels::Lettering& lettering) {
    const double scale = static_cast<double>(still.width()) / crop.picture.width();
    const glm::dvec2 low(still.left + 1, still.top + 1);
    const glm::dvec2 high(still.right - 2, still.bottom - 2);
    const auto at = [&](double x, double y) {
        return glm::clamp(glm::dvec2(still.left + x * scale, still.top + y * scale), low, high);
    };
    constexpr double around = 2;  // field pixels
    const glm::dvec2 from = at(crop.object.left - around, crop.object.top - around);
    const glm::dvec2 to = at(crop.object.right + around, crop.object.bottom + around);
    const double length = std::min({still.width() / 15.0, (to.x - from.x) / 3, (to.y - from.y) / 3});
    const double width = std::max(1.5, still.width() / 80.0);
    for (const auto& [wide, ink] : {std::pair{2 * width, image::Rgba{1, 1, 1, 1}}, std::pair{width, colour}}) {
        for (const double x : {from.x, to.x}) {
            for (const double y : {from.y, to.y}) {
                const glm::dvec2 corner(x, y);
                const double right = x == from.x ? length : -length;
                const double down = y == from.y ? length : -length;
                lettering.strokes.push_back({corner, corner + glm::dvec2(right, 0), wide, ink});
                lettering.strokes.push_back({corner, corner + glm::dvec2(0, down), wide, ink});
            }
        }
    }
}

/// Draws a still with the object's number, activity and time above it.
void label_portrait(const Objects& objects, const Candidate& candidate, const PixelBox& still,
                    const labels::Sheet& sheet, const image::Rgba& ink, const image::Rgba& pale,
                    labels::Lettering& lettering) {
    const events::Event& event = objects.events[candidate.event];
    const int size = sheet.small;
    const int line = size * 4 / 3;
    const int border = std::max(2, size / 5);
    const image::Rgba colour = objects.colour_of(candidate.event);
    lettering.pictures.push_back({still.inflated(-border, -border), candidate.crop->picture, colour, border});
    mark_object(*candidate.crop, still.inflated(-border, -border), colour, lettering);
    const double middle = still.top - 1.5 * line + size * 0.1;
    labels::Badge badge =
        labels::make_badge(fmt::format("{}", objects.numbers[candidate.event]), {still.left, middle}, size, colour);
    badge = labels::make_badge(badge.label.text, {still.left + badge.size / 2, middle}, size, colour);
    const int text_left = static_cast<int>(still.left + badge.size + size * 0.4);
    const int base = still.top - line - size / 4;
    const auto write = [&](const std::vector<std::string>& texts, int x, int y, const image::Rgba& with) {
        const int width = still.right + size / 2 - x;
        for (const std::string& text : texts) {
            const labels::Label label = labels::make_label(text, size, x, y, with);
            if (label.box.width() > width) continue;
            lettering.labels.push_back(label);
            return;
        }
    };
    write(activity_texts(event), text_left, base, ink);
    write(time_texts(event, objects.clock), still.left, base + line, pale);
    lettering.badges.push_back(badge);
    lettering.regions.push_back(
        {{still.left, still.top - 2 * line, still.right, still.bottom}, objects.numbers[candidate.event]});
}

}  // namespace

std::vector<std::size_t> label_portraits(const Objects& objects, const Crops& crops, const Trails& trails,
                                         const labels::Sheet& sheet, const image::Rgba& ink, const image::Rgba& pale,
                                         labels::Lettering& lettering) {
    std::vector<Candidate> candidates;
    std::vector<WantedPortrait> wanted;
    for (const std::size_t k : by_importance(objects.events)) {
        if (candidates.size() == max_candidates) break;
        const events::Event& event = objects.events[k];
        const Crop* const crop = crops.find(event);
        if (crop == nullptr) continue;
        candidates.push_back({k, crop});
        wanted.push_back({event.first.seconds, anchors_of(event, crop->at.seconds, trails)});
    }
    PixelBox row = sheet.portraits;
    row.top += 2 * (sheet.small * 4 / 3);
    std::vector<PixelBox> obstacles;
    for (const labels::Label& label : lettering.labels) obstacles.push_back(label.box.inflated(2, 2));
    std::vector<std::size_t> shown;
    for (const PlacedPortrait& placed : place_portraits(wanted, row, sheet.small, obstacles)) {
        const Candidate& candidate = candidates[placed.wanted];
        const image::Rgba colour = objects.colour_of(candidate.event);
        const double width = std::max(1.0, sheet.small / 9.0);
        lettering.strokes.push_back({placed.from, placed.to, width, colour});
        lettering.strokes.push_back({placed.to, placed.to, 3.5 * width, colour});
        label_portrait(objects, candidate, placed.still, sheet, ink, pale, lettering);
        shown.push_back(candidate.event);
    }
    return shown;
}

void label_numbers(const Objects& objects, const Trails& trails, const labels::Sheet& sheet,
                   labels::Lettering& lettering) {
    std::size_t written = 0;
    const int size = std::max(9, sheet.small - 2);
    for (const std::size_t k : by_importance(objects.events)) {
        const events::Event& event = objects.events[k];
        for (const double share : {0.0, 0.04, 0.08, 0.15}) {
            const double at = std::lerp(event.first.seconds, event.last.seconds, share);
            const labels::Badge badge = labels::make_badge(fmt::format("{}", objects.numbers[k]),
                                                           trails.pixel(event, at), size, objects.colour_of(k));
            if (!sheet.between.contains(badge.box) || !lettering.is_free(badge.box)) continue;
            lettering.badges.push_back(badge);
            lettering.regions.push_back({badge.box, objects.numbers[k]});
            ++written;
            break;
        }
        if (written == max_numbers) return;
    }
}

void label_stays(const Objects& objects, const Trails& trails, const labels::Sheet& sheet,
                 const image::Rgba& background, labels::Lettering& lettering) {
    constexpr std::size_t max_marked = 6;
    constexpr double min_share = 0.05;  // of the longest event; shorter stays are dots on the trail
    double longest = 0;
    for (const events::Event& event : objects.events)
        longest = std::max(longest, event.last.seconds - event.first.seconds);
    const double width = sheet.small / 6.5;
    const glm::dvec2 up(0, sheet.small * 0.9);
    std::size_t marked = 0;
    for (const std::size_t k : by_importance(objects.events)) {
        const events::Event& event = objects.events[k];
        const image::Rgba colour = objects.colour_of(k);
        const std::vector<events::Stay> stays = stationary_times(event);
        const auto stay =
            std::ranges::max_element(stays, {}, [](const events::Stay& s) { return s.last.seconds - s.first.seconds; });
        if (stay == stays.end() || stay->last.seconds - stay->first.seconds < std::max(2.0, min_share * longest))
            continue;
        if (marked++ == max_marked) return;
        for (const Moment& at : {stay->first, stay->last}) {
            const glm::dvec2 place = trails.pixel(event, at.seconds);
            lettering.strokes.push_back({place - up, place + up, 1.8 * width, background});
            lettering.strokes.push_back({place - up, place + up, width, colour});
            for (const double down : {-1.7, 1.7}) {
                labels::Label label =
                    labels::make_centred_label(labels::format_moment(at.seconds, objects.clock), sheet.small, place.x,
                                               place.y + down * sheet.small, colour);
                label.halo = background;
                if (lettering.add(label, sheet.between, 1)) break;
            }
        }
    }
}

}  // namespace vvr::glance
