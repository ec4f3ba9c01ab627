#include "core/labels/legend.h"

#include <algorithm>

namespace vvr {

namespace {

/// The line that letters of a band stand on: letters without tails stand in its middle.
int base_line(const PixelBox& band, int text) {
    return (band.top + band.bottom) / 2 + text * 3 / 8;
}

int width_of(const std::string& text, int size) {
    const auto box = measure_text(text, size);
    return box ? box->width() : 0;
}

}  // namespace

void letter_legend(const std::vector<LegendEntry>& entries, const Sheet& sheet, const Rgba& colour,
                   Lettering& lettering) {
    const int text = sheet.text;
    if (text == 0 || sheet.legend.width() <= 0) return;
    const int bar = 5 * text;
    const int gap = text / 2;
    const int between = 2 * text;
    const auto width = [&](std::string LegendEntry::*words) {
        int sum = 0;
        for (const LegendEntry& entry : entries) sum += bar + gap + width_of(entry.*words, text) + between;
        return sum - between;
    };
    const auto words = width(&LegendEntry::text) <= sheet.legend.width() ? &LegendEntry::text : &LegendEntry::brief;
    int x = sheet.legend.left;
    const int base = base_line(sheet.legend, text);
    for (const LegendEntry& entry : entries) {
        const Label label = make_label(entry.*words, text, x + bar + gap, base, colour);
        if (!lettering.add(label, sheet.legend, gap / 2)) return;
        lettering.bars.push_back({{x, base - text * 3 / 4, x + bar, base}, entry.colours});
        x = label.box.right + between;
    }
}

void letter_title(const std::string& title, const std::string& rest, const Sheet& sheet, const Rgba& colour,
                  const Rgba& pale, Lettering& lettering) {
    const int text = sheet.text;
    if (text == 0 || sheet.title.width() <= 0) return;
    const int base = base_line(sheet.title, text);
    int x = sheet.title.left;
    for (const auto& [words, ink] : {std::pair{title, colour}, std::pair{rest, pale}}) {
        const Label label = make_label(elide(printable(words), text, sheet.title.right - x), text, x, base, ink);
        if (lettering.add(label, sheet.title, 1)) x = label.box.right + text;
    }
}

}  // namespace vvr
