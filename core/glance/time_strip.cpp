#include "core/glance/time_strip.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/text.h"

namespace vvr::glance {

namespace {

/// Draws a time strip: maps times to columns and places the rows.
class Strip {
  public:
    Strip(const Objects& objects, const events::Findings& found, double begin, double end, bool nothing_moved,
          const labels::Sheet& sheet, const StripStyle& style, labels::Lettering& lettering)
        : objects_(objects),
          found_(found),
          begin_(begin),
          end_(end),
          nothing_moved_(nothing_moved),
          sheet_(sheet),
          style_(style),
          lettering_(lettering) {
        const int under = sheet.small * 7 / 4;  // the axis and its times
        const int over = sheet.small * 3 / 2;   // the heading
        rows_ = {sheet.strip.left + 3 * sheet.small / 2, sheet.strip.top + over, sheet.strip.right,
                 sheet.strip.bottom - under};
        row_height_ = std::max(7, sheet.small * 4 / 5);
    }

    void draw() {
        if (rows_.height() < row_height_ || !(end_ > begin_)) return;
        label_axis();
        const std::vector<std::size_t> order = by_importance(objects_.events);
        const double apart = 2.5 * sheet_.small / rows_.width() * (end_ - begin_);
        const std::vector<StripBar> bars = strip_bars(objects_.events, order, rows_.height() / row_height_, apart);
        for (const StripBar& bar : bars) draw_bar(bar);
        // Without events, the clip may still have motion that was too short to be an object.
        if (nothing_moved_ || !objects_.events.empty()) label_idle();
        label_heading(objects_.events.size() - bars.size());
    }

  private:
    int column(double seconds) const {
        const double share = std::clamp((seconds - begin_) / (end_ - begin_), 0.0, 1.0);
        return rows_.left + static_cast<int>(std::lround(share * rows_.width()));
    }

    void label_axis() {
        const double thin = std::max(1.0, sheet_.small / 14.0);
        draw_line(rows_.left, rows_.right, rows_.bottom, thin, style_.lines);
        const int most = std::clamp(rows_.width() / (6 * sheet_.small), 2, 11);
        const int base = rows_.bottom + sheet_.small * 3 / 2;
        for (const labels::TimeTick& tick : labels::time_ticks(begin_, end_, most, objects_.clock)) {
            const int x = column(tick.seconds);
            if (x >= rows_.right) continue;
            const image::Rgba pale = glm::mix(style_.lines, style_.background, 0.6F);
            lettering_.strokes.push_back({{x, rows_.top}, {x, rows_.bottom + sheet_.small / 3}, thin, pale});
            labels::Label label = labels::make_centred_label(tick.text, sheet_.small, x, 0, style_.pale);
            label =
                labels::make_label(tick.text, sheet_.small, std::max(rows_.left, label.box.left), base, style_.pale);
            lettering_.add(label, sheet_.strip, sheet_.small / 4);
        }
    }

    /// A horizontal line between two columns, including its round caps.
    void draw_line(double from, double to, double y, double width, const image::Rgba& colour) {
        const double inset = std::min(width / 2, (to - from) / 2);
        lettering_.strokes.push_back({{from + inset, y}, {to - inset, y}, width, colour});
    }

    void draw_bar(const StripBar& bar) {
        const events::Event& event = objects_.events[bar.event];
        const image::Rgba colour = objects_.colour_of(bar.event);
        const int bottom = rows_.bottom - 1 - bar.row * row_height_;
        const int high = row_height_ - 2;
        const int low = std::max(2, high / 3);
        const int middle = bottom - high / 2;
        const auto add = [&](double from, double to, int height) {
            draw_line(column(from), column(to), middle, height, colour);
        };
        add(event.first.seconds, event.last.seconds, low);
        for (const events::Stay& stay : stationary_times(event)) add(stay.first.seconds, stay.last.seconds, high);
        lettering_.regions.push_back(
            {{column(event.first.seconds), bottom - row_height_, column(event.last.seconds), bottom},
             objects_.numbers[bar.event]});
        label_number(bar, middle);
    }

    /// The object's number before the bar, if there is room.
    void label_number(const StripBar& bar, int middle) {
        const int size = std::max(9, sheet_.small - 2);
        const std::string text = fmt::format("{}", objects_.numbers[bar.event]);
        const labels::Label measured = labels::make_label(text, size, 0, 0, style_.ink);
        const int x = column(objects_.events[bar.event].first.seconds);
        const int left = x - measured.box.width() - 3;
        if (left < sheet_.strip.left) return;
        lettering_.labels.push_back(
            labels::make_centred_label(text, size, left + measured.box.width() / 2.0, middle, style_.ink));
    }

    void label_idle() {
        for (const IdlePeriod& idle : idle_periods(objects_.events, begin_, end_)) {
            // Where something changed that is no object, somebody may have been there.
            const bool changed = std::ranges::any_of(found_.changes, [&](const events::Change& change) {
                return change.first.seconds < idle.end && change.last.seconds > idle.begin;
            });
            if (changed) continue;
            const PixelBox room{column(idle.begin), rows_.top, column(idle.end), rows_.bottom};
            const std::string text = "nobody";
            const labels::Label label = labels::make_centred_label(text, sheet_.small, (room.left + room.right) / 2.0,
                                                                   (room.top + room.bottom) / 2.0, style_.pale);
            lettering_.add(label, room.inflated(-sheet_.small / 3, 0), 2);
        }
    }

    void label_heading(std::size_t without_bar) {
        const std::string more = without_bar > 0 ? fmt::format("; {} more not shown", without_bar) : "";
        std::vector<std::string> texts{"When: a bar for each object, thick where it stood or was left" + more,
                                       "Thick: it stood or was left" + more, "Thick: it stood", "When"};
        if (objects_.events.empty()) texts = texts_without_objects();
        labels::add_first_that_fits(texts, sheet_.small, sheet_.strip.left, sheet_.strip.top + sheet_.small,
                                    sheet_.strip, style_.pale, lettering_);
    }

    std::vector<std::string> texts_without_objects() const {
        if (nothing_moved_) return {"Nothing moved"};
        const int percent = std::max(1, static_cast<int>(std::lround(100 * found_.largest_share)));
        return {fmt::format("Changes in up to {} % of the picture, but none that could be told apart as an object",
                            percent),
                fmt::format("Changes in up to {} % of the picture, no object", percent)};
    }

    const Objects& objects_;
    const events::Findings& found_;
    double begin_;
    double end_;
    bool nothing_moved_;
    const labels::Sheet& sheet_;
    const StripStyle& style_;
    labels::Lettering& lettering_;
    PixelBox rows_;
    int row_height_ = 0;
};

}  // namespace

std::vector<StripBar> strip_bars(std::span<const events::Event> events, std::span<const std::size_t> order, int rows,
                                 double apart) {
    std::vector<std::vector<std::size_t>> taken(static_cast<std::size_t>(std::max(0, rows)));
    std::vector<StripBar> bars;
    for (const std::size_t k : order) {
        const auto collides = [&](std::size_t other) {
            return events[k].first.seconds < events[other].last.seconds + apart &&
                   events[other].first.seconds < events[k].last.seconds + apart;
        };
        const auto free =
            std::ranges::find_if(taken, [&](const auto& row) { return std::ranges::none_of(row, collides); });
        if (free == taken.end()) continue;
        free->push_back(k);
        bars.push_back({k, static_cast<int>(free - taken.begin())});
    }
    return bars;
}

std::vector<IdlePeriod> idle_periods(std::span<const events::Event> events, double begin, double end) {
    std::vector<IdlePeriod> busy;
    for (const events::Event& event : events) busy.push_back({event.first.seconds, event.last.seconds});
    std::ranges::sort(busy, {}, &IdlePeriod::begin);
    std::vector<IdlePeriod> idle;
    double until = begin;
    for (const IdlePeriod& time : busy) {
        if (time.begin > until) idle.push_back({until, time.begin});
        until = std::max(until, time.end);
    }
    if (until < end) idle.push_back({until, end});
    return idle;
}

void label_strip(const Objects& objects, const events::Findings& found, double begin, double end, bool nothing_moved,
                 const labels::Sheet& sheet, const StripStyle& style, labels::Lettering& lettering) {
    Strip(objects, found, begin, end, nothing_moved, sheet, style, lettering).draw();
}

}  // namespace vvr::glance
