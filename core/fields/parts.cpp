#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/fields/flow.h"

namespace vvr {
namespace {

// Tiles are looked at, not pixels: a part's border a few pixels further out does no harm.
constexpr int tile = 16;

// Parts that cover more than this of the picture cost more, with their borders, than the picture.
constexpr double most_of_it = 0.7;

bool touch(const Rect& a, const Rect& b) {
    return a.x < b.x + b.size.width && b.x < a.x + a.size.width && a.y < b.y + b.size.height &&
           b.y < a.y + a.size.height;
}

Rect around(const Rect& a, const Rect& b) {
    const int x = std::min(a.x, b.x);
    const int y = std::min(a.y, b.y);
    return {
        x,
        y,
        {std::max(a.x + a.size.width, b.x + b.size.width) - x, std::max(a.y + a.size.height, b.y + b.size.height) - y}};
}

long area(const Rect& r) {
    return static_cast<long>(r.size.width) * r.size.height;
}

bool any(const Plane<std::uint8_t>& plane, const Rect& r) {
    for (int j = r.y; j < r.y + r.size.height; ++j) {
        const auto row = plane.row(j).subspan(static_cast<std::size_t>(r.x), static_cast<std::size_t>(r.size.width));
        if (std::ranges::any_of(row, [](std::uint8_t p) { return p != 0; })) return true;
    }
    return false;
}

Rect grown(const Rect& r, int margin, Size size) {
    const int x = std::max(r.x - margin, 0);
    const int y = std::max(r.y - margin, 0);
    return {x,
            y,
            {std::min(r.x + r.size.width + margin, size.width) - x,
             std::min(r.y + r.size.height + margin, size.height) - y}};
}

/// Adds a part, made one with all that it touches, and with all that the larger one then touches.
void add(std::vector<Rect>& parts, Rect part) {
    for (std::size_t k = 0; k < parts.size();) {
        if (!touch(parts[k], part)) {
            ++k;
            continue;
        }
        part = around(parts[k], part);
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
        k = 0;
    }
    parts.push_back(part);
}

}  // namespace

std::vector<Rect> parts_about(const Plane<std::uint8_t>& object, int margin) {
    const Size size = object.size();
    std::vector<Rect> parts;
    for (int y = 0; y < size.height; y += tile) {
        for (int x = 0; x < size.width; x += tile) {
            const Rect r{x, y, {std::min(tile, size.width - x), std::min(tile, size.height - y)}};
            if (any(object, r)) add(parts, grown(r, margin, size));
        }
    }
    long covered = 0;
    for (const Rect& part : parts) covered += area(part);
    const Rect whole{0, 0, size};
    if (static_cast<double>(covered) > most_of_it * static_cast<double>(area(whole))) return {whole};
    return parts;
}

}  // namespace vvr
