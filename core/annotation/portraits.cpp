#include "core/annotation/portraits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace vvr::annotation {

namespace {

constexpr double crossing_cost = 1e6;  // exceeds the sum of all lengths
constexpr double obstacle_cost = 300;  // detour in pixels that avoiding an obstacle is worth

/// Twice the signed area of the triangle a, b, c: its sign is the direction of the turn.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool intersects(const glm::dvec2& from, const glm::dvec2& to, const PixelBox& box) {
    const glm::dvec2 corners[] = {
        {box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}};
    for (std::size_t i = 0; i < 4; ++i) {
        if (lines_cross(from, to, corners[i], corners[(i + 1) % 4])) return true;
    }
    return false;
}

/// The places closest to `preferred` that are in order, each at least as far from the first as `offsets` says, by
/// isotonic regression (pool adjacent violators).
std::vector<double> spread(std::span<const double> preferred, std::span<const double> offsets, double low,
                           double high) {
    struct Pool {
        double sum;
        int count;
        double mean() const { return sum / count; }
    };
    std::vector<Pool> pools;
    for (std::size_t i = 0; i < preferred.size(); ++i) {
        pools.push_back({preferred[i] - offsets[i], 1});
        while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
            pools[pools.size() - 2].sum += pools.back().sum;
            pools[pools.size() - 2].count += pools.back().count;
            pools.pop_back();
        }
    }
    const double highest = std::max(low, high - offsets.back());
    std::vector<double> places;
    for (const Pool& pool : pools) {
        for (int i = 0; i < pool.count; ++i) {
            places.push_back(std::clamp(pool.mean(), low, highest) + offsets[places.size()]);
        }
    }
    return places;
}

/// A row of a fixed set of portraits.
class Row {
  public:
    Row(std::span<const WantedPortrait> wanted, std::vector<std::size_t> order, const PixelBox& row, int gap,
        std::span<const PixelBox> obstacles)
        : wanted_(wanted), order_(std::move(order)), row_(row), gap_(gap), obstacles_(obstacles) {
        std::ranges::sort(order_, {}, [&](std::size_t k) { return wanted[k].number; });
    }

    std::vector<PlacedPortrait> place() const {
        std::vector<double> preferred;
        for (const std::size_t k : order_) {
            const auto& anchors = wanted_[k].anchors;
            preferred.push_back(std::ranges::min_element(anchors, {}, &Anchor::cost)->pixel.x);
        }
        std::vector<PlacedPortrait> placed;
        // Stills and anchors depend on each other, so iterate.
        for (int round = 0; round < 3; ++round) {
            placed = choose_anchors(stills_at(preferred));
            for (std::size_t i = 0; i < placed.size(); ++i) preferred[i] = placed[i].to.x;
        }
        return placed;
    }

  private:
    std::vector<PlacedPortrait> stills_at(std::span<const double> preferred) const {
        const auto width = [&](std::size_t k) { return row_.height() * wanted_[k].wide; };
        std::vector<double> lefts;
        std::vector<double> offsets{0};
        for (std::size_t i = 0; i < order_.size(); ++i) {
            lefts.push_back(preferred[i] - width(order_[i]) / 2.0);
            offsets.push_back(offsets.back() + width(order_[i]) + gap_);
        }
        offsets.pop_back();
        const std::vector<double> placed = spread(lefts, offsets, row_.left, row_.right - width(order_.back()));
        std::vector<PlacedPortrait> stills;
        for (std::size_t i = 0; i < order_.size(); ++i) {
            const int left = static_cast<int>(std::floor(placed[i]));
            const PixelBox still{left, row_.top, left + width(order_[i]), row_.bottom};
            stills.push_back({order_[i], still, {placed[i] + width(order_[i]) / 2.0, row_.bottom}, {}});
        }
        return stills;
    }

    double cost_of(const PlacedPortrait& portrait, const Anchor& anchor) const {
        const auto intersected = std::ranges::count_if(
            obstacles_, [&](const PixelBox& box) { return intersects(portrait.from, anchor.pixel, box); });
        return glm::distance(portrait.from, anchor.pixel) + anchor.cost +
               obstacle_cost * static_cast<double>(intersected);
    }

    /// Chooses the anchors with the shortest lines that don't cross a neighbour's, by dynamic programming along the
    /// row.
    std::vector<PlacedPortrait> choose_anchors(std::vector<PlacedPortrait> row) const {
        std::vector<std::vector<double>> costs(row.size());
        std::vector<std::vector<std::size_t>> before(row.size());
        for (std::size_t i = 0; i < row.size(); ++i) {
            for (const Anchor& anchor : wanted_[row[i].wanted].anchors) {
                double least = i == 0 ? 0 : std::numeric_limits<double>::infinity();
                std::size_t from = 0;
                for (std::size_t k = 0; i > 0 && k < costs[i - 1].size(); ++k) {
                    const glm::dvec2& other = wanted_[row[i - 1].wanted].anchors[k].pixel;
                    const bool cross = lines_cross(row[i - 1].from, other, row[i].from, anchor.pixel);
                    const double cost = costs[i - 1][k] + (cross ? crossing_cost : 0);
                    if (cost < least) {
                        least = cost;
                        from = k;
                    }
                }
                costs[i].push_back(least + cost_of(row[i], anchor));
                before[i].push_back(from);
            }
        }
        std::size_t chosen = 0;
        for (std::size_t i = row.size(); i-- > 0;) {
            if (i + 1 == row.size())
                chosen = static_cast<std::size_t>(std::ranges::min_element(costs[i]) - costs[i].begin());
            row[i].to = wanted_[row[i].wanted].anchors[chosen].pixel;
            chosen = before[i][chosen];
        }
        return row;
    }

    std::span<const WantedPortrait> wanted_;
    std::vector<std::size_t> order_;
    PixelBox row_;
    int gap_;
    std::span<const PixelBox> obstacles_;
};

/// The least wanted portrait whose line crosses another.
std::optional<std::size_t> least_wanted_crossing(std::span<const PlacedPortrait> row) {
    std::optional<std::size_t> least;
    for (std::size_t i = 0; i < row.size(); ++i) {
        for (std::size_t k = i + 1; k < row.size(); ++k) {
            if (!lines_cross(row[i].from, row[i].to, row[k].from, row[k].to)) continue;
            least = std::max(least.value_or(0), std::max(row[i].wanted, row[k].wanted));
        }
    }
    return least;
}

}  // namespace

bool lines_cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
    return turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;
}

std::vector<PlacedPortrait> place_portraits(std::span<const WantedPortrait> wanted, const PixelBox& row, int gap,
                                            std::span<const PixelBox> obstacles) {
    if (row.height() <= 0) return {};
    const auto has_room = [&](std::span<const std::size_t> order, const WantedPortrait& one) {
        int width = row.height() * one.wide;
        for (const std::size_t k : order) width += row.height() * wanted[k].wide + gap;
        return width <= row.width();
    };
    std::vector<std::size_t> order;
    std::size_t next = 0;
    while (true) {
        for (; next < wanted.size() && has_room(order, wanted[next]); ++next) {
            if (!wanted[next].anchors.empty()) order.push_back(next);
        }
        if (order.empty()) return {};
        std::vector<PlacedPortrait> placed = Row(wanted, order, row, gap, obstacles).place();
        const std::optional<std::size_t> crossing = least_wanted_crossing(placed);
        if (!crossing) return placed;
        std::erase(order, *crossing);
    }
}

namespace {

// Maximum number of events to try: if lines would cross, less important events take their turn.
constexpr std::size_t max_candidates = 40;
/// Anchors along the trail; those near the portrait's own time cost least.
std::vector<Anchor> anchors_of(const tracking::Event& event, double moment, const Trails& trails) {
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

/// Marks the corners of the object's bounding box, because a still may show other objects too.
void mark_object(const ObjectPicture& shown, const PixelBox& still, const image::Rgba& colour,
                 annotation::Lettering& lettering) {
    const double scale = static_cast<double>(still.width()) / shown.picture.width();
    const glm::dvec2 low(still.left + 1, still.top + 1);
    const glm::dvec2 high(still.right - 2, still.bottom - 2);
    const auto at = [&](double x, double y) {
        return glm::clamp(glm::dvec2(still.left + x * scale, still.top + y * scale), low, high);
    };
    const double around = 2 * shown.scale;  // two field pixels
    const glm::dvec2 from = at(shown.object.left - around, shown.object.top - around);
    const glm::dvec2 to = at(shown.object.right + around, shown.object.bottom + around);
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
void label_portrait(const Objects& objects, const EventPortrait& portrait, const annotation::Sheet& sheet,
                    const image::Rgba& ink, const image::Rgba& pale, annotation::Lettering& lettering) {
    const tracking::Event& event = objects.events[portrait.event];
    const PixelBox& still = portrait.still;
    const int size = sheet.small;
    const int line = size * 4 / 3;
    const int border = std::max(2, size / 5);
    const image::Rgba colour = objects.colour_of(portrait.event);
    const auto show = [&](ObjectPicture shown, const PixelBox& box) {
        mark_object(shown, box, colour, lettering);
        lettering.pictures.push_back({box, std::move(shown.picture), colour, border});
    };
    if (portrait.pair == nullptr) {
        show(portrait.crop->still(), still.inflated(-border, -border));
    } else {
        const PixelBox left{still.left, still.top, still.left + still.height(), still.bottom};
        const PixelBox right{still.right - still.height(), still.top, still.right, still.bottom};
        for (const auto& [words, crop, box] :
             {std::tuple("before", &portrait.pair->before, left), std::tuple("after", &portrait.pair->after, right)}) {
            show(crop->surroundings(), box.inflated(-border, -border));
            annotation::Label label = annotation::make_label(words, size, box.left + 2 * border,
                                                             box.bottom - 3 * border, image::Rgba(1, 1, 1, 1));
            label.halo = image::Rgba(0, 0, 0, 1);
            lettering.labels.push_back(std::move(label));
        }
    }
    const double middle = still.top - 1.5 * line + size * 0.1;
    annotation::Badge badge =
        annotation::make_badge(fmt::format("{}", objects.numbers[portrait.event]), {still.left, middle}, size, colour);
    badge = annotation::make_badge(badge.label.text, {still.left + badge.size / 2, middle}, size, colour);
    const int text_left = static_cast<int>(still.left + badge.size + size * 0.4);
    const int base = still.top - line - size / 4;
    const auto write = [&](const std::vector<std::string>& texts, int x, int y, const image::Rgba& with) {
        const int width = still.right + size / 2 - x;
        for (const std::string& text : texts) {
            const annotation::Label label = annotation::make_label(text, size, x, y, with);
            if (label.box.width() > width) continue;
            lettering.labels.push_back(label);
            return;
        }
    };
    write(activity_texts(event), text_left, base, ink);
    const bool is_with = event.into && !row_of(event.kind).is_thing;
    write(time_texts(event, objects.end, objects.clock, is_with ? objects.numbers[*event.into] : 0), still.left,
          base + line, pale);
    lettering.badges.push_back(badge);
}

}  // namespace

std::vector<EventPortrait> event_portraits(const Objects& objects, const std::set<std::size_t>& numbered,
                                           const Crops& crops, const Trails& trails, const annotation::Sheet& sheet,
                                           std::span<const PixelBox> obstacles, int most_pairs) {
    int pairs = 0;
    std::vector<EventPortrait> candidates;
    std::vector<WantedPortrait> wanted;
    for (const std::size_t k : by_importance(objects.events)) {
        if (candidates.size() == max_candidates) break;
        const tracking::Event& event = objects.events[k];
        const Crop* const crop = crops.find(event);
        if (crop == nullptr || !numbered.contains(k)) continue;
        const BeforeAndAfter* const pair = pairs < most_pairs ? crops.find_pair(event) : nullptr;
        if (pair != nullptr) ++pairs;
        candidates.push_back({k, crop, pair});
        const double moment = pair != nullptr ? event.first.seconds : crop->at().seconds;
        wanted.push_back({objects.numbers[k], anchors_of(event, moment, trails), pair != nullptr ? 2 : 1});
    }
    PixelBox row = sheet.portraits;
    row.top += sheet.captions;
    std::vector<EventPortrait> shown;
    for (const PlacedPortrait& placed : place_portraits(wanted, row, sheet.small, obstacles)) {
        const EventPortrait& candidate = candidates[placed.wanted];
        shown.push_back({candidate.event, candidate.crop, candidate.pair, placed.still, placed.from, placed.to});
    }
    return shown;
}

void label_portraits(const Objects& objects, const std::set<std::size_t>& numbered, const Crops& crops,
                     const Trails& trails, const annotation::Sheet& sheet, const image::Rgba& ink,
                     const image::Rgba& pale, annotation::Lettering& lettering) {
    std::vector<PixelBox> obstacles;
    for (const annotation::Label& label : lettering.labels) obstacles.push_back(label.box.inflated(2, 2));
    constexpr int most_pairs = 3;  // others need room too
    for (const EventPortrait& portrait :
         event_portraits(objects, numbered, crops, trails, sheet, obstacles, most_pairs)) {
        const image::Rgba colour = objects.colour_of(portrait.event);
        const double width = std::max(1.0, sheet.small / 9.0);
        lettering.strokes.push_back({portrait.from, portrait.to, width, colour});
        lettering.strokes.push_back({portrait.to, portrait.to, 3.5 * width, colour});
        label_portrait(objects, portrait, sheet, ink, pale, lettering);
    }
}

}  // namespace vvr::annotation
