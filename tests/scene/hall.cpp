#include "tests/scene/canvas.h"
#include "tests/scene/texture.h"

namespace vvr::generator {
namespace {

/// How near a line of a grid is, 0 on the line and 1 away from it.
double joint(double value, double width) {
    const double off = std::abs(value - std::round(value));
    return std::clamp(off / width, 0.0, 1.0);
}

/// Plaster and stone seen from near: patches of one, two and four pixels, each of its own brightness, spread 1 in all.
double plaster(int i, int j, std::uint64_t seed) {
    double sum = 0;
    for (unsigned scale = 0; scale < 3; ++scale) {
        const auto column = static_cast<std::uint64_t>(i >> scale);
        const auto row = static_cast<std::uint64_t>(j >> scale);
        sum += unit(hash(hash(seed * 4 + scale) + row) + column) - 0.5;
    }
    return 2 * sum;  // each of the three has a spread of 1/sqrt(12)
}

}  // namespace

Plane<Bgr> paint_hall(Size size, std::uint64_t seed, double detail) {
    const Texture coarse(seed * 8 + 1, 40, 300);
    const Texture fine(seed * 8 + 2, 3, 12);
    const double w = size.width;
    const double h = size.height;
    const double skirting = 0.45 * h;  // where wall and floor meet
    Plane<Bgr> picture(size);
    for (int j = 0; j < size.height; ++j)
        for (int i = 0; i < size.width; ++i) {
            const double grain = 0.75 + 0.3 * coarse(i, j) + 0.2 * (fine(i, j) - 0.5);
            Colour colour;
            if (j < skirting) {
                const double shade = 0.85 + 0.15 * joint(i / (w / 8), 0.02);
                colour = Colour{0.55, 0.60, 0.62} * (grain * shade);
                if (j > skirting - 0.025 * h) colour = Colour{0.25, 0.27, 0.30} * grain;
            } else {
                // Tiles in perspective: rows crowd and columns meet towards the horizon.
                const double depth = (0.75 * h) / (j - 0.22 * h);
                const double row = joint(depth * 5, 0.06);
                const double column = joint((i - w / 2) / w * depth * 6, 0.03);
                colour = Colour{0.48, 0.52, 0.55} * (grain * (0.82 + 0.18 * row * column));
            }
            const double speck = detail > 0 ? detail / 255 * plaster(i, j, seed) : 0;
            picture.at(i, j) = to_bgr({colour.b + speck, colour.g + speck, colour.r + speck});
        }

    Canvas canvas(&picture);
    const auto box = [&](Point middle, Point half, double corner, Colour colour) {
        const Point m{middle.x * w, middle.y * h};
        const Point s{half.x * w, half.y * h};
        canvas.paint(
            m, std::max(s.x, s.y) + 1, [&](Point p) { return round_box(p, m, s, corner * h); },
            [&](Point p) { return colour * (0.85 + 0.3 * fine(p.x, p.y)); });
    };
    box({0.72, 0.27}, {0.065, 0.18}, 0.005, {0.20, 0.24, 0.30});   // door frame
    box({0.72, 0.275}, {0.055, 0.17}, 0.003, {0.33, 0.42, 0.52});  // door
    box({0.695, 0.29}, {0.004, 0.012}, 0.003, {0.8, 0.8, 0.75});   // its handle
    box({0.18, 0.20}, {0.09, 0.09}, 0.004, {0.72, 0.66, 0.58});    // notice board
    box({0.15, 0.18}, {0.025, 0.05}, 0.002, {0.9, 0.93, 0.95});    // notices
    box({0.21, 0.21}, {0.03, 0.045}, 0.002, {0.75, 0.85, 0.6});
    box({0.43, 0.435}, {0.10, 0.015}, 0.004, {0.22, 0.35, 0.45});  // bench
    box({0.36, 0.475}, {0.008, 0.035}, 0.002, {0.2, 0.2, 0.22});
    box({0.50, 0.475}, {0.008, 0.035}, 0.002, {0.2, 0.2, 0.22});
    box({0.90, 0.44}, {0.03, 0.07}, 0.01, {0.35, 0.30, 0.22});  // bin
    return picture;
}

}  // namespace vvr::generator
