#include "core/annotation/time_strip.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/plane.h"
#include "core/base/text.h"
#include "core/tracking/event_options.h"

namespace vvr::annotation {

namespace {

constexpr int number_gap = 3;  // pixels between a number and its bar

/// Draws a time strip: maps times to columns and places the rows.
class Strip {
  public:
    Strip(const Objects& objects, const StripContent& content, const annotation::Sheet& sheet, const StripStyle& style,
          annotation::Lettering& lettering)
        : objects_(objects), content_(content), sheet_(sheet), style_(style), lettering_(lettering) {
        const int under = sheet.small * 7 / 4;  // the axis and its times
        const int over = sheet.small * 3 / 2;   // the heading
        rows_ = {sheet.strip.left + 3 * sheet.small / 2, sheet.strip.top + over, sheet.strip.right,
                 sheet.strip.bottom - under};
        number_size_ = std::max(9, sheet.small - 2);
        row_height_ = std::max(7, sheet.small * 4 / 5);
    }

    std::vector<std::size_t> draw() {
        if (rows_.height() < row_height_ || !(content_.end > content_.begin)) return {};
        label_axis();
        for (const condition::Interval& interval : content_.intervals) hatch(interval);
        const std::vector<StripBar> bars = place_bars();
        std::vector<std::size_t> with_bar;
        for (const StripBar& bar : bars) {
            if (draw_bar(bar)) with_bar.push_back(bar.event);
        }
        // Without events, the clip may still have motion that was too short to be an object.
        if (content_.nothing_moved || !objects_.events.empty()) label_idle();
        label_heading(objects_.events.size() - bars.size());
        for (const condition::Interval& interval : content_.intervals) label_interval(interval);
        return with_bar;
    }

  private:
    /// Places the bars. If there are many, rows are as low as the numbers allow.
    std::vector<StripBar> place_bars() {
        const std::vector<std::size_t> order = by_importance(objects_.events);
        const double seconds_per_pixel = (content_.end - content_.begin) / rows_.width();
        const double apart = (number_width() + 2 * number_gap) * seconds_per_pixel;
        const auto bars = [&] { return strip_bars(objects_.events, order, rows_.height() / row_height_, apart); };
        std::vector<StripBar> usual = bars();
        if (usual.size() == objects_.events.size()) return usual;
        const annotation::Label digit = annotation::make_label("0", number_size_, 0, 0, style_.ink);
        row_height_ = std::clamp(digit.box.height(), 7, row_height_);
        return bars();
    }

    /// The width of the widest number, pixels.
    int number_width() const {
        std::size_t highest = 0;
        for (const std::size_t number : objects_.numbers) highest = std::max(highest, number);
        return annotation::make_label(fmt::format("{}", highest), number_size_, 0, 0, style_.ink).box.width();
    }

    int column(double seconds) const {
        const double share = std::clamp((seconds - content_.begin) / (content_.end - content_.begin), 0.0, 1.0);
        return rows_.left + static_cast<int>(std::lround(share * rows_.width()));
    }

    void label_axis() {
        const double thin = std::max(1.0, sheet_.small / 14.0);
        draw_line(rows_.left, rows_.right, rows_.bottom, thin, style_.lines);
        const int most = std::clamp(rows_.width() / (6 * sheet_.small), 2, 11);
        const int base = rows_.bottom + sheet_.small * 3 / 2;
        for (const annotation::TimeTick& tick :
             annotation::time_ticks(content_.begin, content_.end, most, objects_.clock)) {
            const int x = column(tick.seconds);
            if (x >= rows_.right) continue;
            const image::Rgba pale = glm::mix(style_.lines, style_.background, 0.6F);
            lettering_.strokes.push_back({{x, rows_.top}, {x, rows_.bottom + sheet_.small / 3}, thin, pale});
            annotation::Label label = annotation::make_centred_label(tick.text, sheet_.small, x, 0, style_.pale);
            label = annotation::make_label(tick.text, sheet_.small, std::max(rows_.left, label.box.left), base,
                                           style_.pale);
            lettering_.add(label, sheet_.strip, sheet_.small / 4);
        }
    }

    /// A horizontal line between two columns, including its round caps.
    void draw_line(double from, double to, double y, double width, const image::Rgba& colour) {
        const double inset = std::min(width / 2, (to - from) / 2);
        lettering_.strokes.push_back({{from + inset, y}, {to - inset, y}, width, colour});
    }

    PixelBox room_of(const condition::Interval& interval) const {
        return {column(interval.begin), rows_.top, column(interval.end), rows_.bottom};
    }

    /// Hatches a time in which nobody could be seen.
    void hatch(const condition::Interval& interval) {
        const PixelBox room = room_of(interval);
        const double thin = std::max(1.0, sheet_.small / 14.0);
        const int apart = std::max(4, sheet_.small / 2);
        for (int x = room.left - room.height(); x < room.right; x += apart) {
            const int left = std::max(x, room.left);
            const int right = std::min(x + room.height(), room.right);
            if (left < right)
                lettering_.strokes.push_back(
                    {{left, room.bottom - (left - x)}, {right, room.bottom - (right - x)}, thin, style_.lines});
        }
        // What takes no time, such as a knock, is a line.
        if (room.width() < apart)
            lettering_.strokes.push_back({{room.left, room.top}, {room.left, room.bottom}, 2 * thin, style_.pale});
    }

    /// Says why a time is hatched: beside the heading, where no bars are, or else in the hatching.
    void label_interval(const condition::Interval& interval) {
        const PixelBox room = room_of(interval);
        const std::string words(row_of(interval.kind).words);
        const int width = annotation::make_label(words, sheet_.small, 0, 0, style_.pale).box.width();
        const int middle = (room.left + room.right - width) / 2;
        const int inside = width > room.width() ? room.right + number_gap : middle;
        const int beside = sheet_.strip.top + sheet_.small;
        for (const glm::ivec2& place : {glm::ivec2(middle, beside), glm::ivec2(room.right - width, beside),
                                        glm::ivec2(inside, room.top + sheet_.small)}) {
            annotation::Label label = annotation::make_label(words, sheet_.small, place.x, place.y, style_.pale);
            label.halo = style_.background;
            if (lettering_.add(label, sheet_.strip, 2)) return;
        }
    }

    /// \returns whether the bar has a number
    bool draw_bar(const StripBar& bar) {
        const tracking::Event& event = objects_.events[bar.event];
        const image::Rgba colour = objects_.colour_of(bar.event);
        const int bottom = rows_.bottom - 1 - bar.row * row_height_;
        const int high = row_height_ - 2;
        const int low = std::max(2, high / 3);
        const int middle = bottom - high / 2;
        const tracking::EventKindRow& kind = row_of(event.kind);
        const int from = column(event.first.seconds);
        const int to = column(event.last.seconds);
        if (kind.is_of_scene) {
            draw_dashes(from, to, middle, high * 2 / 3.0, colour);
        } else {
            draw_line(from, to, middle, low, colour);
            for (const tracking::Stay& stay : stationary_times(event)) {
                const int begin = column(stay.first.seconds);
                const int end = column(stay.last.seconds);
                draw_line(begin, end, middle, high, colour);
                if (!kind.lies) draw_stripes(begin, end, middle, high, colour);
            }
        }
        return label_number(bar, middle);
    }

    void draw_dashes(int from, int to, int y, double width, const image::Rgba& colour) {
        const int dash = sheet_.small;
        for (int x = from; x < to; x += dash * 3 / 2) draw_line(x, std::min(x + dash, to), y, width, colour);
    }

    /// The stripes that the volume has where an object stayed.
    void draw_stripes(int from, int to, int y, int height, const image::Rgba& colour) {
        const double width = std::max(1.5, sheet_.small / 5.0);
        const double half = (height - width) / 2;
        const image::Rgba dark = glm::mix(colour, image::Rgba{0, 0, 0, 1}, 0.6F);
        const double inside = height / 2.0;  // of the round caps
        for (double x = from + inside; x <= to - inside; x += 2.2 * width)
            lettering_.strokes.push_back({{x, y - half}, {x, y + half}, width, dark});
    }

    /// The object's number before the bar, if there is room.
    bool label_number(const StripBar& bar, int middle) {
        const std::string text = fmt::format("{}", objects_.numbers[bar.event]);
        const annotation::Label measured = annotation::make_label(text, number_size_, 0, 0, style_.ink);
        const int x = column(objects_.events[bar.event].first.seconds);
        const int left = x - measured.box.width() - number_gap;
        if (left < sheet_.strip.left) return false;
        lettering_.labels.push_back(
            annotation::make_centred_label(text, number_size_, left + measured.box.width() / 2.0, middle, style_.ink));
        return true;
    }

    void label_idle() {
        std::vector<Period> busy(content_.unexplained.begin(), content_.unexplained.end());
        busy.insert(busy.end(), content_.not_chosen.begin(), content_.not_chosen.end());
        for (const tracking::Event& event : objects_.events) busy.push_back({event.first.seconds, event.last.seconds});
        // Where something changed that is no object, somebody may have been there.
        for (const tracking::Change& change : content_.found.changes)
            busy.push_back({change.first.seconds, change.last.seconds});
        const std::vector<Period> idle_ones = idle_periods(std::move(busy), content_.begin, content_.end);
        for (const Period& idle : idle_ones) {
            // The number of the next bar is at the end of the gap.
            const int number = idle.end < content_.end ? number_width() + number_gap : 0;
            const PixelBox room{column(idle.begin), rows_.top, column(idle.end) - number, rows_.bottom};
            const annotation::Label label =
                annotation::make_centred_label("nobody found", sheet_.small, (room.left + room.right) / 2.0,
                                               (room.top + room.bottom) / 2.0, style_.pale);
            lettering_.add(label, room.inflated(-sheet_.small / 3, 0), 2);
        }
    }

    void label_heading(std::size_t without_bar) {
        const std::string more = without_bar > 0 ? fmt::format("; no room for {} more", without_bar) : "";
        const auto has = [&](auto&& is_so) { return std::ranges::any_of(objects_.events, is_so); };
        std::vector<std::string> looks;
        std::vector<std::string> brief;
        if (has([](const tracking::Event& event) {
                return !row_of(event.kind).lies && !row_of(event.kind).is_of_scene && !event.stays.empty();
            })) {
            looks.emplace_back("striped where it stayed");
            brief.emplace_back("striped: stayed");
        }
        std::vector<std::string_view> lying;
        for (const tracking::EventKindRow& row : tracking::event_kinds) {
            if (row.lies && has([&](const tracking::Event& event) { return event.kind == row.kind; }))
                lying.push_back(row.words);
        }
        if (!lying.empty()) {
            looks.push_back(fmt::format("thick while {}", fmt::join(lying, " or ")));
            brief.push_back(fmt::format("thick: {}", fmt::join(lying, " or ")));
        }
        if (has([](const tracking::Event& event) { return row_of(event.kind).is_of_scene; })) {
            looks.emplace_back("dashed while a thing that was taken is gone");
            brief.emplace_back("dashed: taken");
        }
        std::vector<std::string> texts{
            fmt::format("When: a bar for each object{}{}{}", looks.empty() ? "" : ", ", fmt::join(looks, ", "), more),
            fmt::format("When; {}{}", fmt::join(brief, ", "), more), fmt::format("When; {}", fmt::join(brief, ", ")),
            "When"};
        if (objects_.events.empty()) texts = texts_without_objects();
        annotation::add_first_that_fits(texts, sheet_.small, sheet_.strip.left, sheet_.strip.top + sheet_.small,
                                        sheet_.strip, style_.pale, lettering_);
    }

    std::vector<std::string> texts_without_objects() const {
        if (content_.nothing_moved) return {"No objects"};
        if (!content_.not_chosen.empty()) {
            const std::string others = counted(std::ssize(content_.not_chosen), "object");
            return {fmt::format("{} found, but none that --events chooses", others),
                    fmt::format("{}, none chosen", others)};
        }
        const int percent = std::max(1, static_cast<int>(std::lround(100 * content_.found.largest_share)));
        return {fmt::format("Changes in up to {} % of the picture, but none could be identified as an object", percent),
                fmt::format("Changes in up to {} % of the picture, no object", percent)};
    }

    const Objects& objects_;
    const StripContent& content_;
    const annotation::Sheet& sheet_;
    const StripStyle& style_;
    annotation::Lettering& lettering_;
    PixelBox rows_;
    int row_height_ = 0;
    int number_size_ = 0;
};

/// Whether fewer than `rows` of the others are there at each moment of a place.
bool has_row(const Period& place, std::span<const Period> others, int rows) {
    std::vector<std::pair<double, int>> steps;  // ends sort before the beginnings at the same time
    for (const Period& other : others) {
        if (!other.overlaps(place)) continue;
        steps.emplace_back(other.begin, 1);
        steps.emplace_back(other.end, -1);
    }
    std::ranges::sort(steps);
    int at_once = 0;
    int most = 0;
    for (const auto& [seconds, step] : steps) {
        at_once += step;
        if (seconds < place.end) most = std::max(most, at_once);
    }
    return most < rows;
}

}  // namespace

std::vector<StripBar> strip_bars(std::span<const tracking::Event> events, std::span<const std::size_t> order, int rows,
                                 double apart) {
    // The time that an event takes in its row.
    const auto place_of = [&](std::size_t k) {
        return Period{events[k].first.seconds, events[k].last.seconds + apart};
    };
    std::vector<std::size_t> chosen;
    std::vector<Period> places;
    for (const std::size_t k : order) {
        if (!has_row(place_of(k), places, rows)) continue;
        chosen.push_back(k);
        places.push_back(place_of(k));
    }
    // Intervals need as many rows as there are at once, if rows are assigned in the order of their beginnings.
    std::ranges::sort(chosen, {}, [&](std::size_t k) { return std::pair(events[k].first.seconds, k); });
    std::vector<double> until(static_cast<std::size_t>(std::max(0, rows)), -std::numeric_limits<double>::infinity());
    std::vector<StripBar> bars;
    for (const std::size_t k : chosen) {
        const Period place = place_of(k);
        const auto row = std::ranges::find_if(until, [&](double end) { return end <= place.begin; });
        if (row == until.end()) continue;
        *row = place.end;
        bars.push_back({k, static_cast<int>(row - until.begin())});
    }
    return bars;
}

std::vector<std::size_t> label_strip(const Objects& objects, const StripContent& content,
                                     const annotation::Sheet& sheet, const StripStyle& style,
                                     annotation::Lettering& lettering) {
    return Strip(objects, content, sheet, style, lettering).draw();
}

namespace {

/// Whether something compact in a layer belongs to no object: it fills a quarter of a block of the picture. Leaves,
/// rain and noise are scattered.
bool has_unowned_thing(const volume::Volume& volume, const volume::Layer& layer,
                       const volume::VoxelStyleLookup& identify) {
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

std::vector<Period> unexplained_periods(const volume::Volume& volume, const volume::VoxelStyleLookup& identify) {
    std::vector<Period> periods;
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        const volume::Layer& layer = volume.layer(i);
        // A few lost frames hide nobody.
        const bool has_frames = 2 * layer.missing < layer.frames;
        if (has_frames && !has_unowned_thing(volume, layer, identify)) continue;
        const double end = i + 1 < volume.layers() ? volume.layer(i + 1).pts : layer.last_pts;
        if (!periods.empty() && periods.back().end >= layer.pts) {
            periods.back().end = end;
        } else {
            periods.push_back({layer.pts, end});
        }
    }
    std::erase_if(periods,
                  [](const Period& period) { return period.end - period.begin < tracking::thresholds.event.least; });
    return periods;
}

}  // namespace vvr::annotation
