#include "core/annotation/sheet.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vvr::annotation {

namespace {

// Smaller pictures get no text. Units: the text size.
constexpr int min_lines = 16;
constexpr int min_width = 24;

constexpr int smallest_text = 11;

int text_size(Size picture) {
    const double side = std::sqrt(static_cast<double>(picture.width) * picture.height);
    const int size = std::max(smallest_text, static_cast<int>(std::lround(side / 62)));
    return picture.height < min_lines * size || picture.width < min_width * size ? 0 : size;
}

// Smaller pictures get no portraits, end frames or time strip, which would be illegible. Units: the text size.
constexpr int min_lines_for_stills = 34;
constexpr int min_width_for_stills = 48;

// Aspect ratio of a horseshoe at the default view, plus some margin.
constexpr double max_arc_aspect = 0.5;

/// Whether the legend shares the title's band; otherwise it has its own band at the bottom.
bool shares_band(const PixelBox& inside, const SheetParts& parts, const Sheet& sheet) {
    constexpr int min_width_to_share = 64;  // in text sizes
    return parts.legend && parts.title && inside.width() >= min_width_to_share * sheet.text;
}

/// Whether there is a row of stills below the volume, and room for it.
bool has_stills(const PixelBox& inside, const SheetParts& parts) {
    constexpr double least = 0.7;  // height divided by width
    return parts.ends && parts.stills && inside.height() >= least * inside.width();
}

/// Divides a band into the first frame, stills and the last frame, all of one size.
void arrange_stills(const PixelBox& band, double aspect, Sheet& sheet) {
    const int gap = sheet.text / 2;
    constexpr int fewest = 7;
    const int count = std::max(fewest, static_cast<int>((band.width() + gap) / (band.height() * aspect + gap)));
    const int width = (band.width() - (count - 1) * gap) / count;
    const int height = static_cast<int>(std::lround(width / aspect));
    const auto place = [&](int k) {
        // The last one ends at the margin.
        const int left = k + 1 == count ? band.right - width : band.left + k * (width + gap);
        return PixelBox{left, band.bottom - height, left + width, band.bottom};
    };
    sheet.first = place(0);
    for (int k = 1; k + 1 < count; ++k) sheet.stills.push_back(place(k));
    sheet.last = place(count - 1);
}

/// Arranges the bottom of the picture: the end frames and the strip between them.
void arrange_bottom(const PixelBox& inside, const SheetParts& parts, double aspect, Sheet& sheet) {
    const int gap = sheet.text;
    const int caption = sheet.small * 3 / 2;
    int floor = inside.bottom;
    if (parts.legend && !shares_band(inside, parts, sheet)) {
        floor -= sheet.text * 3 / 2;
        sheet.legend = {inside.left, floor, inside.right, inside.bottom};
    }
    const int inside_floor = floor;
    int top = floor;
    PixelBox middle{inside.left, 0, inside.right, floor};
    if (has_stills(inside, parts)) {
        if (parts.strip) floor -= 8 * sheet.text + gap / 2;
        arrange_stills({inside.left, floor - inside.height() * 2 / 15, inside.right, floor}, aspect, sheet);
        top = sheet.first.top - caption;
        if (parts.strip) sheet.strip = {inside.left, inside_floor - 8 * sheet.text, inside.right, inside_floor};
        sheet.between.bottom = top;
        sheet.map_area = {inside.left, 0, inside.right, top};
        return;
    }
    if (parts.ends) {
        // Large enough to recognise people in the frames.
        const int height = std::min(inside.height() * 9 / 50, static_cast<int>(inside.width() * 0.22 / aspect));
        const int width = static_cast<int>(std::lround(height * aspect));
        sheet.first = {inside.left, floor - height, inside.left + width, floor};
        sheet.last = {inside.right - width, floor - height, inside.right, floor};
        top = sheet.first.top - caption;
        middle.left = sheet.first.right + gap;
        middle.right = sheet.last.left - gap;
    }
    if (parts.strip) sheet.strip = {middle.left, floor - 8 * sheet.text, middle.right, floor};
    sheet.between.bottom = std::min(top, parts.strip ? sheet.strip.top : floor);
    // Between the end frames, or above them in portrait format.
    const int bottom = parts.strip ? sheet.strip.top : floor;
    sheet.map_area = {middle.left, 0, middle.right, bottom};
    if (inside.height() > inside.width()) sheet.map_area = {inside.left, 0, inside.right, top};
}

/// Arranges the top of the picture: title, explanation, portraits.
void arrange_top(const PixelBox& inside, const SheetParts& parts, Sheet& sheet) {
    int top = inside.top;
    const auto take = [&](int height) {
        top += height;
        return PixelBox{inside.left, top - height, inside.right, top};
    };
    if (parts.title) sheet.title = take(sheet.text * 3 / 2);
    if (shares_band(inside, parts, sheet)) sheet.legend = sheet.title;
    if (parts.explanation) sheet.explanation = take(sheet.small * 3 / 2);
    if (parts.portraits) {
        const int still = std::min(inside.height() * 4 / 25, inside.width() / (has_stills(inside, parts) ? 10 : 6));
        take(sheet.small / 2);
        sheet.captions = (parts.large_captions ? 4 : 2) * (sheet.small * 4 / 3);
        sheet.portraits = take(still + sheet.captions);
    }
    sheet.between.top = top;
}

}  // namespace

Sheet arrange_sheet(Size picture, const SheetParts& wanted, double aspect) {
    Sheet sheet;
    sheet.picture = picture;
    sheet.between = {0, 0, picture.width, picture.height};
    sheet.volume = sheet.between;
    const bool any = wanted.title || wanted.ruler || wanted.legend || wanted.explanation || wanted.portraits ||
                     wanted.ends || wanted.strip;
    sheet.text = any ? text_size(picture) : 0;
    if (sheet.text == 0) return sheet;

    const int text = sheet.text;
    sheet.small = std::max(smallest_text, text * 13 / 16);
    sheet.edge = text * 3 / 4;
    SheetParts parts = wanted;
    if (picture.height < min_lines_for_stills * text || picture.width < min_width_for_stills * text) {
        parts.explanation = parts.portraits = parts.ends = parts.strip = false;
    }
    const PixelBox inside{sheet.edge, sheet.edge, picture.width - sheet.edge, picture.height - sheet.edge};
    sheet.between = inside;
    arrange_top(inside, parts, sheet);
    arrange_bottom(inside, parts, aspect, sheet);
    sheet.volume = sheet.between;
    if (parts.ruler) {
        const auto widest = image::measure_text("00:00:00", text);
        const int beside = widest ? widest->width() + text / 2 : 0;
        sheet.volume = {sheet.between.left + beside, sheet.between.top + text * 3 / 2, sheet.between.right - beside,
                        sheet.between.bottom - text / 2};
    }
    // In a tall picture, keep the volume near the portraits and leave the rest to the map.
    if (parts.portraits) {
        const int max_bottom = sheet.volume.top + static_cast<int>(sheet.volume.width() * max_arc_aspect);
        sheet.volume.bottom = std::min(sheet.volume.bottom, max_bottom);
    }
    return sheet;
}

namespace {

/// Baseline of a band's text; letters without descenders are centred in the band.
int base_line(const PixelBox& band, int text) {
    return (band.top + band.bottom) / 2 + text * 3 / 8;
}

int width_of(const std::string& text, int size) {
    const auto box = image::measure_text(text, size);
    return box ? box->width() : 0;
}

// In text sizes.
constexpr int bar_width = 5;
constexpr int wheel_width = 2;
constexpr int space_between = 2;

/// Width of the entry's colours and the gap after them.
int before_text(const LegendEntry& entry, int text) {
    if (entry.colours.empty()) return 0;
    return (entry.wheel ? wheel_width : bar_width) * text + text / 2;
}

/// A colour wheel of spokes that touch at the rim.
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

/// Width of all entries, each with the space after it.
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
    // In the title's band, start after the title.
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

}  // namespace vvr::annotation
