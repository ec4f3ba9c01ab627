#include "core/labels/sheet.h"

#include <algorithm>
#include <cmath>

namespace vvr {

namespace {

// Below so many lines of text in height, or so many of its sizes in width, text would take more room than it is worth.
constexpr int least_lines = 16;
constexpr int least_width = 24;

constexpr int smallest_text = 11;

int text_size(Size picture) {
    const double side = std::sqrt(static_cast<double>(picture.width) * picture.height);
    const int size = std::max(smallest_text, static_cast<int>(std::lround(side / 62)));
    return picture.height < least_lines * size || picture.width < least_width * size ? 0 : size;
}

}  // namespace

Sheet arrange_sheet(Size picture, const SheetParts& parts) {
    Sheet sheet;
    sheet.picture = picture;
    sheet.between = {0, 0, picture.width, picture.height};
    sheet.volume = sheet.between;
    sheet.text = parts.title || parts.ruler || parts.legend ? text_size(picture) : 0;
    if (sheet.text == 0) return sheet;

    const int text = sheet.text;
    sheet.edge = text * 3 / 4;
    const PixelBox inside{sheet.edge, sheet.edge, picture.width - sheet.edge, picture.height - sheet.edge};
    const int band = text * 3 / 2;
    if (parts.title) sheet.title = {inside.left, inside.top, inside.right, inside.top + band};
    if (parts.legend) sheet.legend = {inside.left, inside.bottom - band, inside.right, inside.bottom};
    sheet.between = {inside.left, parts.title ? sheet.title.bottom : inside.top, inside.right,
                     parts.legend ? sheet.legend.top : inside.bottom};
    sheet.volume = sheet.between;
    if (parts.ruler) {
        const auto widest = measure_text("00:00:00", text);
        const int beside = widest ? widest->width() + text / 2 : 0;
        sheet.volume = {sheet.between.left + beside, sheet.between.top + text, sheet.between.right - beside,
                        sheet.between.bottom - text / 2};
    }
    return sheet;
}

}  // namespace vvr
