#include "core/labels/legend.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vvr::labels {

namespace {

/// The line that letters of a band stand on: letters without tails stand in its middle.
int base_line(const PixelBox& band, int text) {
    return (band.top + band.bottom) / 2 + text * 3 / 8;
}

int width_of(const std::string& text, int size) {
    const auto box = image::measure_text(text, size);
    return box ? box->width() : 0;
}

// In sizes of the text.
constexpr int bar_width = 5;
constexpr int wheel_width = 2;
constexpr int space_between = 2;

/// Of its colours, and the gap behind them.
int before_text(const LegendEntry& entry, int text) {
    if (entry.colours.empty()) return 0;
    return (entry.wheel ? wheel_width : bar_width) * text + text / 2;
}

/// A wheel of spokes that touch each other at the rim.
void draw_wheel(const std::vector<image::Rgba>& colours, const glm::dvec2& middle, double radius,
                Lettering& lettering) {
    const double turn = 2 * std::numbers::pi / static_cast<double>(colours.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const double angle = turn * static_cast<double>(i);
        const glm::dvec2 out(std::cos(angle), -std::sin(angle));
        lettering.strokes.push_back(
            {middle + 0.4 * radius * out, middle + radius * out, 1.4 * turn * radius, colours[i]});
    }
}

/// Of all entries, each with the space after it.
int width_of(const std::vector<LegendEntry>& entries, std::string LegendEntry::*words, int text) {
    int sum = 0;
    for (const LegendEntry& entry : entries) {
        sum += before_text(entry, text) + width_of(entry.*words, text) + space_between * text;
    }
    return sum;
}

}  // namespace

int brief_width(const std::vector<LegendEntry>& entries, const Sheet& sheet) {
    return width_of(entries, &LegendEntry::brief, sheet.small);
}

void label_legend(const std::vector<LegendEntry>& entries, const Sheet& sheet, const image::Rgba& colour,
                   Lettering& lettering) {
    const int text = sheet.small;
    if (sheet.text == 0 || sheet.legend.width() <= 0) return;
    const int gap = text / 2;
    const int between = space_between * text;
    // Beside the title: what that has left over.
    PixelBox room = sheet.legend;
    for (const Label& label : lettering.labels) {
        if (label.box.intersects(room)) room.left = std::max(room.left, label.box.right + between);
    }
    const auto width = [&](std::string LegendEntry::*words) { return width_of(entries, words, text) - between; };
    const auto words = width(&LegendEntry::text) <= room.width() ? &LegendEntry::text : &LegendEntry::brief;
    int x = sheet.legend == sheet.title ? std::max(room.left, room.right - width(words)) : room.left;
    const int base = base_line(sheet.legend, text);
    for (const LegendEntry& entry : entries) {
        const int before = before_text(entry, text);
        const Label label = make_label(entry.*words, text, x + before, base, colour);
        if (!room.contains(label.box) || !lettering.add(label, sheet.legend, gap / 2)) return;
        if (entry.wheel) {
            const double radius = wheel_width * text / 2.0;
            draw_wheel(entry.colours, {x + radius, base - text * 3 / 8.0}, radius, lettering);
        } else if (!entry.colours.empty()) {
            lettering.bars.push_back({{x, base - text * 3 / 4, x + before - gap, base}, entry.colours});
        }
        x = label.box.right + between;
    }
}

void label_title(const std::string& title, const std::string& rest, int right, const Sheet& sheet,
                  const image::Rgba& colour, const image::Rgba& pale, Lettering& lettering) {
    const int text = sheet.text;
    if (text == 0 || sheet.title.width() <= 0) return;
    const int base = base_line(sheet.title, text);
    int x = sheet.title.left;
    const auto write = [&](const std::string& words, int end, const image::Rgba& ink) {
        const Label label = make_label(elide(image::printable(words), text, end - x), text, x, base, ink);
        if (lettering.add(label, sheet.title, 1)) x = label.box.right + text;
    };
    write(title, right, colour);
    write(rest, sheet.title.right, pale);
}

}  // namespace vvr::labels
