#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>

#include "core/base/plane.h"

namespace vvr::generator {

struct Point {
    double x = 0;
    double y = 0;

    friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
    friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
    friend Point operator*(Point point, double factor) { return {point.x * factor, point.y * factor}; }
};

/// Blue, green, red as fractions of white.
struct Colour {
    double b = 0;
    double g = 0;
    double r = 0;

    friend Colour operator*(Colour colour, double factor) {
        return {colour.b * factor, colour.g * factor, colour.r * factor};
    }
};

/// A level of a pixel, rounded. std::lround would be a call for each.
inline std::uint8_t to_level(double value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0) + 0.5);  // NOLINT(bugprone-incorrect-roundings)
}

inline std::uint8_t to_byte(double fraction) {
    return to_level(fraction * 255);
}

/// The length of a vector. std::hypot minds overflow, which no picture has, and takes ten times as long.
inline double length_of(double x, double y) {
    return std::sqrt(x * x + y * y);
}

inline Bgr to_bgr(Colour colour) {
    return {to_byte(colour.b), to_byte(colour.g), to_byte(colour.r)};
}

/// The distance from `p` to a line from `a` to `b` whose thickness runs from radius `ra` to `rb`; negative inside.
inline double limb(Point p, Point a, Point b, double ra, double rb) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length2 = dx * dx + dy * dy;
    const double t = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0;
    return length_of(p.x - a.x - t * dx, p.y - a.y - t * dy) - (ra + t * (rb - ra));
}

/// The distance from `p` to a box with round corners; negative inside.
inline double round_box(Point p, Point middle, Point half, double corner) {
    const double dx = std::abs(p.x - middle.x) - half.x + corner;
    const double dy = std::abs(p.y - middle.y) - half.y + corner;
    return length_of(std::max(dx, 0.0), std::max(dy, 0.0)) + std::min(std::max(dx, dy), 0.0) - corner;
}

/// A picture to paint shapes on, and optionally a mask of where they are.
class Canvas {
  public:
    explicit Canvas(Plane<Bgr>* picture, Plane<std::uint8_t>* mask = nullptr) : picture_(picture), mask_(mask) {}

    /// Paints what lies within `reach` of `middle`.
    ///
    /// \param distance of a point to the shape in pixels, negative inside
    /// \param colour of a point
    /// \param strength 1 = opaque; less is a shadow, which leaves no mark in the mask
    template <std::regular_invocable<Point> Distance, std::regular_invocable<Point> Paint>
    void paint(Point middle, double reach, const Distance& distance, const Paint& colour, double strength = 1) {
        const Size size = picture_ ? picture_->size() : mask_->size();
        const auto bound = [](double value, int most) {
            return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(most)));
        };
        for (int j = bound(middle.y - reach, size.height); j < bound(middle.y + reach + 2, size.height); ++j)
            for (int i = bound(middle.x - reach, size.width); i < bound(middle.x + reach + 2, size.width); ++i) {
                const Point p{static_cast<double>(i), static_cast<double>(j)};
                const double cover = std::clamp(0.5 - distance(p), 0.0, 1.0) * strength;
                if (cover <= 0) continue;
                if (picture_) blend(picture_->at(i, j), colour(p), cover);
                if (mask_ && strength == 1 && cover >= 0.5) mask_->at(i, j) = 255;
            }
    }

    /// The same of one colour.
    template <std::regular_invocable<Point> Distance>
    void paint(Point middle, double reach, const Distance& distance, Colour colour, double strength = 1) {
        paint(
            middle, reach, distance, [=](Point) { return colour; }, strength);
    }

    void paint_disc(Point middle, double radius, Colour colour) {
        paint(
            middle, radius + 1, [=](Point p) { return limb(p, middle, middle, radius, radius); }, colour);
    }

  private:
    static void blend(Bgr& under, Colour over, double cover) {
        const Bgr colour = to_bgr(over);
        for (std::size_t c = 0; c < under.size(); ++c) under[c] = to_level(under[c] + (colour[c] - under[c]) * cover);
    }

    Plane<Bgr>* picture_;
    Plane<std::uint8_t>* mask_;
};

/// A paved hall with a wall, a door, a bench and a bin: detail everywhere, so that flow has something to hold on to.
Plane<Bgr> paint_hall(Size size, std::uint64_t seed, double detail);

}  // namespace vvr::generator
