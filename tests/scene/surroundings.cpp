// Scenes whose surroundings change: clocks, leaves, balloons, lamps.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tests/scene/actors.h"
#include "tests/scene/texture.h"

namespace vvr::generator {
namespace {

// A digit has seven strokes; a bit for each, from the top clockwise, the one in the middle last.
constexpr std::array<unsigned, 10> strokes_of{0x3f, 0x06, 0x5b, 0x4f, 0x66, 0x6d, 0x7d, 0x07, 0x7f, 0x6f};
struct Stroke {
    Point from;
    Point to;
};
constexpr std::array<Stroke, 7> strokes{Stroke{{0, 0}, {4, 0}}, Stroke{{4, 0}, {4, 4}}, Stroke{{4, 4}, {4, 8}},
                                        Stroke{{0, 8}, {4, 8}}, Stroke{{0, 4}, {0, 8}}, Stroke{{0, 0}, {0, 4}},
                                        Stroke{{0, 4}, {4, 4}}};
constexpr std::array<double, 6> digits_at{0, 8, 18, 26, 36, 44};  // hours, minutes, seconds
constexpr Point clock_corner{118, 5};
constexpr int always = std::numeric_limits<int>::max();

std::array<int, 6> digits_of(int seconds) {
    const int hours = seconds / 3600;
    const int minutes = seconds / 60 % 60;
    return {hours / 10, hours % 10, minutes / 10, minutes % 10, seconds % 60 / 10, seconds % 10};
}

Actor clock(const Options& options, Point corner) {
    constexpr int begins = (12 * 60 + 34) * 60 + 45;
    const double scale = scale_of(options);
    return {"clock",
            [=](double) {
                return std::optional(Point{corner.x + 24, corner.y + 4});
            },
            [=](Canvas& canvas, double frame) {
                // The clock's second doesn't begin with the clip.
                const double phase = 25 * unit(options.seed * 31);
                const auto digits = digits_of(begins + static_cast<int>((frame + phase) / 25));
                for (std::size_t k = 0; k < digits.size(); ++k) {
                    const Point at{corner.x + digits_at[k], corner.y};
                    for (std::size_t n = 0; n < strokes.size(); ++n) {
                        if (((strokes_of[static_cast<std::size_t>(digits[k])] >> n) & 1U) == 0) continue;
                        const Point a{(at.x + strokes[n].from.x) * scale, (at.y + strokes[n].from.y) * scale};
                        const Point b{(at.x + strokes[n].to.x) * scale, (at.y + strokes[n].to.y) * scale};
                        canvas.paint(
                            a, 7 * scale, [&](Point p) { return limb(p, a, b, 0.7 * scale, 0.7 * scale); },
                            [](Point) {
                                return Colour{1, 1, 1};
                            });
                    }
                }
            }};
}

/// A tree whose leaves sway by up to four pixels, each in its own way.
Actor leaves(const Options& options) {
    const double scale = scale_of(options);
    const Point middle{144, 24};
    const Point half{50, 28};
    return {"leaves", at_place(middle, {0, always}), [=](Canvas& canvas, double frame) {
                const Point m{middle.x * scale, middle.y * scale};
                const Point h{half.x * scale, half.y * scale};
                canvas.paint(
                    m, h.x + h.y, [&](Point p) { return round_box(p, m, h, 4 * scale); },
                    [](Point) {
                        return Colour{0.10, 0.18, 0.12};
                    });
                const double gust = 2.5 + 1.5 * wander(frame, 170, options.seed);
                for (std::uint64_t k = 0; k < 160; ++k) {
                    const std::uint64_t leaf = options.seed * 1000 + k * 4;
                    const double period = 40 + 60 * unit(leaf);
                    const Point at{
                        middle.x + (2 * unit(leaf + 1) - 1) * half.x + gust * wander(frame, period, leaf),
                        middle.y + (2 * unit(leaf + 2) - 1) * half.y + gust * wander(frame, period, leaf + 1)};
                    const Point p0{at.x * scale, at.y * scale};
                    const double radius = (1.5 + 2 * unit(leaf + 3)) * scale;
                    const double light = 0.2 + 0.45 * unit(leaf + 5000);
                    canvas.paint(
                        p0, radius + 1, [&](Point p) { return limb(p, p0, p0, radius, radius); },
                        [&](Point) {
                            return Colour{0.4 * light, light, 0.5 * light};
                        });
                }
            }};
}

Actor balloon(const Options& options, std::string name, double x, Colour colour, std::uint64_t seed) {
    constexpr double radius = 9;
    const double scale = scale_of(options);
    const Way middle = [=, seed = options.seed * 16 + seed](double frame) {
        // A wind that comes and goes.
        const double wind = 0.6 + 0.4 * wander(frame, 330, seed + 7);
        return std::optional(Point{x + radius * wind * 1.6 * wander(frame, 120, seed),
                                   44 + 0.3 * radius * wander(frame, 150, seed + 3)});
    };
    return {std::move(name), middle, [=](Canvas& canvas, double frame) {
                const Point at = *middle(frame);
                const Point m{at.x * scale, at.y * scale};
                const Point weight{x * scale, 110 * scale};
                canvas.paint(
                    {x * scale, 77 * scale}, 50 * scale, [&](Point p) { return limb(p, m, weight, 0.5, 0.5); },
                    [](Point) {
                        return Colour{0.9, 0.9, 0.9};
                    });
                canvas.paint(
                    m, radius * scale + 1, [&](Point p) { return limb(p, m, m, radius * scale, radius * scale); },
                    [&](Point) { return colour; });
            }};
}

/// Light that falls on a quarter of the picture, with soft edges.
Actor lamp(const Options& options) {
    const double scale = scale_of(options);
    const Point middle{60, 84};
    return {"lamp", at_place(middle, {lamp_on(), always}), [=](Canvas& canvas, double) {
                const Point m{middle.x * scale, middle.y * scale};
                const Point half{48 * scale, 36 * scale};
                canvas.paint(
                    m, half.x + half.y, [&](Point p) { return round_box(p, m, half, 20 * scale) / (8 * scale); },
                    [](Point) {
                        return Colour{1, 1, 1};
                    },
                    0.35);
            }};
}

}  // namespace

PixelBox clock_line() {
    return {117, 4, 168, 15};
}

PixelBox clock_seconds() {
    return {154, 5, 167, 14};
}

Scene make_clock(const Options& options) {
    return make_happening(options, 750, {clock(options, clock_corner)});
}

Scene make_clock_over_leaves(const Options& options) {
    return make_happening(options, 1000, {leaves(options), clock(options, clock_corner)});
}

Scene make_clock_and_walker(const Options& options) {
    return make_happening(
        options, 600, {walker("person", options, {across(200, 1.2, 132), 7}), clock(options, {clock_corner.x, 122})});
}

Scene make_balloons(const Options& options) {
    return make_happening(options, 750,
                          {balloon(options, "balloon 0", 40, {0.15, 0.15, 0.85}, 1),
                           balloon(options, "balloon 1", 96, {0.1, 0.8, 0.9}, 2),
                           balloon(options, "balloon 2", 156, {0.8, 0.3, 0.1}, 3)});
}

int lamp_on() {
    return 200;
}

Scene make_lamp(const Options& options) {
    return make_happening(options, 500, {lamp(options)});
}

Scene make_lamp_and_walker(const Options& options) {
    return make_happening(options, 500, {walker("person", options, {across(150, 1.2, 116), 2}), lamp(options)});
}

}  // namespace vvr::generator
