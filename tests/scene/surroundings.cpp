// Scenes whose surroundings change: clocks, leaves, balloons, lamps.
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

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
                return corner + Point{24, 4};
            },
            [=](Canvas& canvas, double frame) {
                // The clock's second doesn't begin with the clip.
                const double phase = 25 * unit(options.seed * 31);
                const auto digits = digits_of(begins + static_cast<int>((frame + phase) / 25));
                for (std::size_t k = 0; k < digits.size(); ++k) {
                    const Point at{corner.x + digits_at[k], corner.y};
                    for (std::size_t n = 0; n < strokes.size(); ++n) {
                        if (((strokes_of[static_cast<std::size_t>(digits[k])] >> n) & 1U) == 0) continue;
                        const Point a = (at + strokes[n].from) * scale;
                        const Point b = (at + strokes[n].to) * scale;
                        const auto stroke = [&](Point p) { return limb(p, a, b, 0.7 * scale, 0.7 * scale); };
                        canvas.paint(a, 7 * scale, stroke, Colour{1, 1, 1});
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
                const Point m = middle * scale;
                const Point h = half * scale;
                const auto crown = [&](Point p) { return round_box(p, m, h, 4 * scale); };
                canvas.paint(m, h.x + h.y, crown, Colour{0.10, 0.18, 0.12});
                const double gust = 2.5 + 1.5 * wander(frame, 170, options.seed);
                for (std::uint64_t k = 0; k < 160; ++k) {
                    const std::uint64_t leaf = options.seed * 1000 + k * 4;
                    const double period = 40 + 60 * unit(leaf);
                    const Point at{
                        middle.x + (2 * unit(leaf + 1) - 1) * half.x + gust * wander(frame, period, leaf),
                        middle.y + (2 * unit(leaf + 2) - 1) * half.y + gust * wander(frame, period, leaf + 1)};
                    const double light = 0.2 + 0.45 * unit(leaf + 5000);
                    canvas.paint_disc(at * scale, (1.5 + 2 * unit(leaf + 3)) * scale, Colour{0.4, 1, 0.5} * light);
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
                const Point m = *middle(frame) * scale;
                const Point weight{x * scale, 110 * scale};
                const auto string = [&](Point p) { return limb(p, m, weight, 0.5, 0.5); };
                canvas.paint({x * scale, 77 * scale}, 50 * scale, string, Colour{0.9, 0.9, 0.9});
                canvas.paint_disc(m, radius * scale, colour);
            }};
}

/// Light that falls on a quarter of the picture, with soft edges.
Actor lamp(const Options& options) {
    const double scale = scale_of(options);
    const Point middle{60, 84};
    return {"lamp", at_place(middle, {lamp_on(), always}), [=](Canvas& canvas, double) {
                const Point m = middle * scale;
                const Point half{48 * scale, 36 * scale};
                const auto spot = [&](Point p) { return round_box(p, m, half, 20 * scale) / (8 * scale); };
                canvas.paint(m, half.x + half.y, spot, Colour{1, 1, 1}, 0.35);
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
