#include "core/labels/lettering.h"

#include <algorithm>
#include <cmath>

namespace vvr {

namespace {

bool is_middle_of_character(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

}  // namespace

bool Lettering::add(const Label& label, const PixelBox& area, int gap) {
    if (label.text.empty() || !area.holds(label.box)) return false;
    const PixelBox around = label.box.grown(gap, gap);
    const auto in_the_way = [&](const auto& other) { return around.meets(other.box); };
    if (std::ranges::any_of(labels, in_the_way) || std::ranges::any_of(bars, in_the_way)) return false;
    labels.push_back(label);
    return true;
}

Label make_label(const std::string& text, int size, int x, int y, const Rgba& colour) {
    const std::optional<PixelBox> box = measure_text(text, size);
    if (!box) return {};
    return {text, size, x - box->left, y, box->moved(x - box->left, y), colour};
}

Label make_label_around(const std::string& text, int size, double x, double y, const Rgba& colour) {
    const std::optional<PixelBox> box = measure_text(text, size);
    if (!box) return {};
    const int left = static_cast<int>(std::lround(x - box->width() / 2.0)) - box->left;
    const int base = static_cast<int>(std::lround(y - box->height() / 2.0)) - box->top;
    return {text, size, left, base, box->moved(left, base), colour};
}

std::string elide(const std::string& text, int size, int width) {
    const auto fits = [&](const std::string& candidate) {
        const std::optional<PixelBox> box = measure_text(candidate, size);
        return box && box->width() <= width;
    };
    if (fits(text)) return text;
    std::string shorter = text;
    while (!shorter.empty()) {
        while (!shorter.empty() && is_middle_of_character(shorter.back())) shorter.pop_back();
        if (!shorter.empty()) shorter.pop_back();
        if (fits(shorter + "…")) return shorter.empty() ? shorter : shorter + "…";
    }
    return {};
}

void draw(Picture& picture, const Lettering& lettering) {
    for (const ColourBar& bar : lettering.bars) {
        for (int i = bar.box.left; i < bar.box.right; ++i) {
            const auto colour = static_cast<std::size_t>(i - bar.box.left) * bar.colours.size() /
                                static_cast<std::size_t>(bar.box.width());
            for (int j = bar.box.top; j < bar.box.bottom; ++j) picture.pixels.at(i, j) = bar.colours[colour];
        }
    }
    for (const Label& label : lettering.labels) {
        draw_text(picture, label.x, label.y, label.text, label.size, label.colour);
    }
}

}  // namespace vvr
