#include "core/annotation/lettering.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "core/base/text.h"
#include "core/image/picture.h"

namespace vvr::annotation {

namespace {

/// Luma, 0..1.
float lightness(const image::Rgba& colour) {
    return 0.299F * colour.r + 0.587F * colour.g + 0.114F * colour.b;
}

void fill(image::Picture& picture, const PixelBox& box, const image::Rgba& colour) {
    const PixelBox inside = intersection(box, {0, 0, picture.pixels.width(), picture.pixels.height()});
    for (int j = inside.top; j < inside.bottom; ++j) {
        for (int i = inside.left; i < inside.right; ++i) picture.pixels.at(i, j) = colour;
    }
}

void draw_pasted(image::Picture& picture, const PastedPicture& pasted) {
    if (pasted.border > 0) fill(picture, pasted.box.inflated(pasted.border, pasted.border), pasted.colour);
    const Plane<Bgr> scaled = image::resized(pasted.picture, pasted.box.size());
    for (int j = 0; j < scaled.height(); ++j) {
        for (int i = 0; i < scaled.width(); ++i) {
            const Bgr& bgr = scaled.at(i, j);
            picture.pixels.at(pasted.box.left + i, pasted.box.top + j) =
                image::Rgba(bgr[2], bgr[1], bgr[0], 255) / 255.0F;
        }
    }
}

void draw_label(image::Picture& picture, const Label& label) {
    if (label.halo) {
        const int reach = std::max(1, label.size / 11);
        for (const int x : {-reach, 0, reach}) {
            for (const int y : {-reach, 0, reach})
                image::draw_text(picture, label.x + x, label.y + y, label.text, label.size, *label.halo);
        }
    }
    image::draw_text(picture, label.x, label.y, label.text, label.size, label.colour);
}

}  // namespace

bool Lettering::is_free(const PixelBox& box) const {
    const auto intersects = [&](const auto& other) { return box.intersects(other.box); };
    return std::ranges::none_of(labels, intersects) && std::ranges::none_of(bars, intersects) &&
           std::ranges::none_of(pictures, intersects) && std::ranges::none_of(badges, intersects);
}

std::set<std::string> Lettering::missing_characters() const {
    std::set<std::string> missing;
    for (const Label& label : labels) missing.merge(image::missing_characters(label.text));
    for (const Badge& badge : badges) missing.merge(image::missing_characters(badge.label.text));
    return missing;
}

bool Lettering::add(const Label& label, const PixelBox& area, int gap) {
    if (label.text.empty() || !area.contains(label.box)) return false;
    if (!is_free(label.box.inflated(gap, gap))) return false;
    labels.push_back(label);
    return true;
}

Label make_label(const std::string& text, int size, int x, int y, const image::Rgba& colour) {
    const std::optional<PixelBox> box = image::measure_text(text, size);
    if (!box) return {};
    return {text, size, x - box->left, y, box->translated(x - box->left, y), colour};
}

Label make_centred_label(const std::string& text, int size, double x, double y, const image::Rgba& colour) {
    const std::optional<PixelBox> box = image::measure_text(text, size);
    if (!box) return {};
    const int left = static_cast<int>(std::lround(x - box->width() / 2.0)) - box->left;
    const int base = static_cast<int>(std::lround(y - box->height() / 2.0)) - box->top;
    return {text, size, left, base, box->translated(left, base), colour};
}

Badge make_badge(const std::string& text, const glm::dvec2& middle, int size, const image::Rgba& colour) {
    const float ink = lightness(colour) > 0.55F ? 0.0F : 1.0F;
    Badge badge{
        make_centred_label(text, size, middle.x, middle.y, {ink, ink, ink, 1}), middle, size * 1.35, colour, {}};
    badge.size = std::max(badge.size, badge.label.box.width() + size * 0.5);
    const int half = static_cast<int>(std::ceil(badge.size / 2));
    const glm::ivec2 at(glm::round(middle));
    badge.box = {at.x - half, at.y - half, at.x + half, at.y + half};
    return badge;
}

void add_first_that_fits(std::span<const std::string> texts, int size, int x, int y, const PixelBox& area,
                         const image::Rgba& colour, Lettering& lettering) {
    for (const std::string& text : texts) {
        if (lettering.add(make_label(text, size, x, y, colour), area, 0)) return;
    }
}

std::string elide(const std::string& text, int size, int width) {
    const auto fits = [&](const std::string& candidate) {
        const std::optional<PixelBox> box = image::measure_text(candidate, size);
        return box && box->width() <= width;
    };
    // Letters are at least a pixel wide, so this bounds the bytes to measure, however long the text is.
    const std::size_t max_bytes = 4 * static_cast<std::size_t>(std::max(0, width));
    if (text.size() <= max_bytes && fits(text)) return text;
    std::vector<std::size_t> ends;  // of each character but the last
    for (std::size_t end = 0; end < std::min(text.size(), max_bytes);) {
        end += first_character(std::string_view(text).substr(end)).value_or(Character{0, 1}).length;
        ends.push_back(end);
    }
    if (!ends.empty() && ends.back() == text.size()) ends.pop_back();
    const auto too_long =
        std::ranges::partition_point(ends, [&](std::size_t end) { return fits(text.substr(0, end) + "…"); });
    return too_long == ends.begin() ? std::string() : text.substr(0, *std::prev(too_long)) + "…";
}

void draw(image::Picture& picture, const Lettering& lettering) {
    for (const PastedPicture& pasted : lettering.pictures) draw_pasted(picture, pasted);
    for (const ColourBar& bar : lettering.bars) {
        for (int i = bar.box.left; i < bar.box.right; ++i) {
            const auto colour = static_cast<std::size_t>(i - bar.box.left) * bar.colours.size() /
                                static_cast<std::size_t>(bar.box.width());
            fill(picture, {i, bar.box.top, i + 1, bar.box.bottom}, bar.colours[colour]);
        }
    }
    for (const Stroke& stroke : lettering.strokes) {
        image::draw_line(picture, stroke.from, stroke.to, stroke.width, stroke.colour);
    }
    for (const Badge& badge : lettering.badges) {
        image::draw_line(picture, badge.middle, badge.middle, badge.size, badge.colour);
        image::draw_text(picture, badge.label.x, badge.label.y, badge.label.text, badge.label.size, badge.label.colour);
    }
    for (const Label& label : lettering.labels) draw_label(picture, label);
}

}  // namespace vvr::annotation
