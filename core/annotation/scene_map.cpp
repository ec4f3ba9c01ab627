#include "core/annotation/scene_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/fields/planes.h"
#include "core/image/picture.h"

namespace vvr::annotation {

namespace {

// More coloured paths would be indistinguishable.
constexpr std::size_t max_paths = 8;
constexpr image::Rgba casing{1, 1, 1, 1};

/// Reduces contrast and saturation, so that what is drawn over the picture stands out.
Plane<Bgr> paled(Plane<Bgr> picture, const image::Rgba& towards) {
    const std::array<float, 3> background{towards.b * 255, towards.g * 255, towards.r * 255};
    for (int j = 0; j < picture.height(); ++j) {
        for (Bgr& pixel : picture.row(j)) {
            const int grey = fields::brightness_of(pixel);
            for (std::size_t c = 0; c < 3; ++c) {
                const auto greyer = static_cast<float>(pixel[c] + grey) / 2;
                pixel[c] = static_cast<std::uint8_t>(std::lerp(background[c], greyer, 0.6F));
            }
        }
    }
    return picture;
}

class Map {
  public:
    Map(const Objects& objects, Size field, const PixelBox& box, int text, annotation::Lettering& lettering)
        : objects_(objects), field_(field), box_(box), text_(text), lettering_(lettering) {}

    std::vector<std::size_t> draw() {
        const std::vector<std::size_t> order = by_importance(objects_.events);
        const std::size_t coloured = std::min(order.size(), max_paths);
        for (std::size_t i = order.size(); i-- > coloured;) draw_faint(objects_.events[order[i]]);
        for (std::size_t i = coloured; i-- > 0;) draw_path(order[i]);
        for (std::size_t i = coloured; i-- > 0;) draw_stays(order[i]);
        std::vector<std::size_t> numbered;
        for (std::size_t i = 0; i < coloured; ++i) {
            if (draw_number(order[i])) numbered.push_back(order[i]);
        }
        return numbered;
    }

  private:
    glm::dvec2 pixel(const glm::dvec2& place) const {
        const glm::dvec2 share = (place + 0.5) / glm::dvec2(field_.width, field_.height);
        return glm::dvec2(box_.left, box_.top) +
               glm::clamp(share, 0.0, 1.0) * glm::dvec2(box_.width() - 1, box_.height() - 1);
    }

    std::vector<glm::dvec2> points_of(const tracking::Event& event) const {
        std::vector<glm::dvec2> points;
        for (const tracking::PathPoint& point : event.path) {
            const glm::dvec2 at = pixel(point.place);
            if (points.empty() || glm::distance(points.back(), at) > 1.5) points.push_back(at);
        }
        return points;
    }

    void draw_faint(const tracking::Event& event) {
        const std::vector<glm::dvec2> points = points_of(event);
        for (std::size_t i = 1; i < points.size(); ++i) {
            lettering_.strokes.push_back({points[i - 1], points[i], 1, image::Rgba{0.2F, 0.2F, 0.2F, 1} * 0.18F});
        }
    }

    void draw_path(std::size_t k) {
        const std::vector<glm::dvec2> points = points_of(objects_.events[k]);
        const double width = std::max(1.5, text_ / 7.0);
        const image::Rgba colour = objects_.colour_of(k);
        for (const auto& [wide, ink] : {std::pair{width + 1.2, casing}, std::pair{width, colour}}) {
            for (std::size_t i = 1; i < points.size(); ++i)
                lettering_.strokes.push_back({points[i - 1], points[i], wide, ink});
            if (points.size() > 1) draw_arrow_head(points, wide, ink);
        }
    }

    /// Two short strokes at the end of the path.
    void draw_arrow_head(std::span<const glm::dvec2> points, double width, const image::Rgba& colour) {
        const glm::dvec2 tip = points.back();
        const double length = text_ * 0.65;
        // The last segment may be a pixel long, so take the direction over the head's length.
        glm::dvec2 from = points.front();
        for (std::size_t i = points.size(); i-- > 0;) {
            if (glm::distance(points[i], tip) < length) continue;
            from = points[i];
            break;
        }
        if (glm::distance(from, tip) < 2) return;
        const glm::dvec2 back = glm::normalize(from - tip) * length;
        const double angle = 0.5;
        for (const double sign : {-1.0, 1.0}) {
            const double c = std::cos(angle);
            const double s = sign * std::sin(angle);
            lettering_.strokes.push_back(
                {tip, tip + glm::dvec2(c * back.x - s * back.y, s * back.x + c * back.y), width, colour});
        }
    }

    /// A dot where the object was stationary; its size grows with the duration.
    void draw_stays(std::size_t k) {
        for (const tracking::Stay& stay : stationary_times(objects_.events[k])) {
            const double seconds = stay.last.seconds - stay.first.seconds;
            const double size = text_ * std::clamp(0.35 + 0.2 * std::log2(1 + seconds / 4), 0.4, 1.4);
            const glm::dvec2 at = pixel(stay.place);
            lettering_.strokes.push_back({at, at, size + 2, casing});
            lettering_.strokes.push_back({at, at, size, objects_.colour_of(k)});
        }
    }

    /// The number at the start of the path. If another number is there, it moves aside, and a line leads to the path.
    /// \returns whether there is room for it
    bool draw_number(std::size_t k) {
        const tracking::Event& event = objects_.events[k];
        const image::Rgba colour = objects_.colour_of(k);
        const auto badge_at = [&](const glm::dvec2& middle) {
            return annotation::make_badge(fmt::format("{}", objects_.numbers[k]), middle, std::max(9, text_ - 2),
                                          colour);
        };
        const glm::dvec2 begin = pixel(event.path.empty() ? position_at(event, 0) : event.path.front().place);
        const double size = badge_at(begin).size;
        const double margin = size / 2 + 2;
        const glm::dvec2 low = glm::dvec2(box_.left, box_.top) + margin;
        const glm::dvec2 high = glm::dvec2(box_.right, box_.bottom) - margin;
        const glm::dvec2 at = glm::clamp(begin, low, high);
        for (int attempt = 0; attempt < 12; ++attempt) {
            const double angle = attempt * 2.4;  // golden angle: spreads the attempts
            const double away = size * 0.35 * attempt;
            const glm::dvec2 there = at + away * glm::dvec2(std::cos(angle), std::sin(angle));
            const bool inside = glm::clamp(there, low, high) == there;
            if (attempt > 0 && !inside) continue;
            const bool free = std::ranges::all_of(
                numbers_, [&](const glm::dvec2& other) { return glm::distance(other, there) > size; });
            if (!free) continue;
            numbers_.push_back(there);
            if (glm::distance(there, at) > size / 2) {
                const double width = std::max(1.0, text_ / 9.0);
                lettering_.strokes.push_back({there, at, width + 1.2, casing});
                lettering_.strokes.push_back({there, at, width, colour});
            }
            lettering_.badges.push_back(badge_at(there));
            return true;
        }
        return false;
    }

    const Objects& objects_;
    Size field_;
    PixelBox box_;
    int text_;
    annotation::Lettering& lettering_;
    std::vector<glm::dvec2> numbers_;
};

}  // namespace

std::vector<std::size_t> draw_map(const Objects& objects, const Plane<Bgr>& scene, Size field, const PixelBox& box,
                                  int text, const image::Rgba& background, annotation::Lettering& lettering) {
    if (scene.empty() || box.empty()) return {};
    lettering.pictures.push_back({box, paled(image::resized(scene, box.size()), background), {}, 0});
    return Map(objects, field, box, text, lettering).draw();
}

PixelBox map_box(const space::Layout& layout, const space::Camera& camera, Size picture, const PixelBox& area,
                 double aspect) {
    constexpr int samples = 128;
    const double middle = (area.left + area.right) / 2.0;
    // A point of the volume's surface in the picture.
    struct SurfacePoint {
        double from_middle;  ///< horizontal distance from the middle of `area`, pixels
        double row;
    };
    std::vector<SurfacePoint> surface;
    double lowest_of_arc = 0;
    for (int i = 0; i <= samples; ++i) {
        const double t = static_cast<double>(i) / samples;
        for (const double x : {0.0, 0.5, 1.0}) {
            for (const double y : {0.0, 1.0}) {
                const glm::dvec2 at = camera.pixel(layout.p_from_c({x, y, t}), picture);
                surface.push_back({std::abs(at.x - middle), at.y});
                if (i == samples / 2) lowest_of_arc = std::max(lowest_of_arc, at.y);
            }
        }
    }
    if (area.empty()) return {};
    const double gap = picture.height * 0.012;
    PixelBox best;
    for (int half = 20; half < area.width() / 2; half += 2) {
        double top = lowest_of_arc;
        for (const SurfacePoint& at : surface) {
            if (at.from_middle < half + gap) top = std::max(top, at.row);
        }
        const int height = static_cast<int>(2 * half / aspect);
        const int first = static_cast<int>(std::ceil(top + gap));
        if (first + height + gap > area.bottom) break;
        best = {static_cast<int>(middle) - half, first, static_cast<int>(middle) + half, first + height};
    }
    return best;
}

}  // namespace vvr::annotation
