#include "tests/scene/figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/scene/texture.h"

namespace vvr::generator {
namespace {

// Proportions as parts of the height, heights counted from the floor.
constexpr double hip = 0.50;
constexpr double shoulder = 0.81;
constexpr double head = 0.925;
constexpr double thigh = 0.25;
constexpr double shin = 0.25;
constexpr double arm = 0.19;

Point away(Point from, double angle, double length, double facing) {
    return {from.x + facing * std::sin(angle) * length, from.y + std::cos(angle) * length};
}

struct Joints {
    Point hip;
    Point shoulder;
    Point head;
    std::array<Point, 2> knee;
    std::array<Point, 2> foot;
    std::array<Point, 2> elbow;
    std::array<Point, 2> hand;
};

Joints joints_of(const Figure& figure) {
    const double h = figure.height;
    const double lift = 0.015 * h * figure.gait * std::abs(std::cos(figure.stride));
    Joints joints;
    joints.hip = {figure.feet.x, figure.feet.y - hip * h - lift + 0.1 * h * figure.bow};
    // Angles are from the plumb line, forwards.
    const double lean = 3.14 - 0.05 * figure.gait - 1.25 * figure.bow;
    joints.shoulder = away(joints.hip, lean, (shoulder - hip) * h, figure.facing);
    joints.head = away(joints.hip, lean - 0.05, (head - hip) * h, figure.facing);
    for (std::size_t side = 0; side < 2; ++side) {
        const double phase = figure.stride + (side == 0 ? 0 : 3.14159265);
        const double swing = 0.45 * figure.gait * std::sin(phase);
        const double bend = 0.12 + 0.55 * figure.gait * std::max(0.0, std::cos(phase)) + 0.5 * figure.bow;
        joints.knee[side] = away(joints.hip, swing + 0.1 + 0.35 * figure.bow, thigh * h, figure.facing);
        joints.foot[side] = away(joints.knee[side], swing + 0.1 - bend, shin * h, figure.facing);
        const double reach = -0.5 * figure.gait * std::sin(phase) * (side == 0 ? 0.25 : 1);
        joints.elbow[side] = away(joints.shoulder, reach - 0.1 + 0.2 * figure.bow, arm * h, figure.facing);
        joints.hand[side] = away(joints.elbow[side], reach + 0.2 + 0.1 * figure.bow, arm * h, figure.facing);
    }
    const auto tip = [&](Point& p) {
        const Point d = p - figure.feet;
        const double angle = figure.facing * figure.fall;
        p = {figure.feet.x + std::cos(angle) * d.x - std::sin(angle) * d.y,
             figure.feet.y + std::sin(angle) * d.x + std::cos(angle) * d.y};
    };
    for (Point* const p : {&joints.hip, &joints.shoulder, &joints.head}) tip(*p);
    for (auto* const pair : {&joints.knee, &joints.foot, &joints.elbow, &joints.hand})
        std::ranges::for_each(*pair, tip);
    return joints;
}

}  // namespace

Point middle_of(const Figure& figure) {
    return away(figure.feet, 3.14159265 - figure.fall, figure.height / 2, figure.facing);
}

Point hand_of(const Figure& figure) {
    return joints_of(figure).hand[0];
}

void paint_shadow(Canvas& canvas, Point feet, double width) {
    const auto distance = [&](Point p) {
        return (length_of((p.x - feet.x) / width, (p.y - feet.y) / (0.22 * width)) - 1) * 0.22 * width;
    };
    canvas.paint(feet, width, distance, Colour{0.08, 0.08, 0.08}, 0.35);
}

void paint_figure(Canvas& canvas, const Figure& figure) {
    const auto joints = joints_of(figure);
    const double h = figure.height;
    const Texture cloth(figure.seed + 100, 4, 16);
    const auto tint = [&](std::uint64_t part, double least, double most) {
        const auto channel = [&](std::uint64_t c) {
            return least + (most - least) * unit(figure.seed * 97 + part * 3 + c);
        };
        return Colour{channel(0), channel(1), channel(2)};
    };
    const Colour coat = tint(1, 0.08, 0.75);
    const Colour trousers = tint(2, 0.05, 0.30);
    const Colour skin{0.50, 0.62, 0.80};
    const Colour hair = tint(3, 0.03, 0.22);

    const auto part = [&](Point a, Point b, double ra, double rb, Colour colour) {
        const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        const double reach = length_of(b.x - a.x, b.y - a.y) / 2 + std::max(ra, rb) * h + 1;
        canvas.paint(
            middle, reach, [&](Point p) { return limb(p, a, b, ra * h, rb * h); },
            // The cloth moves with the body.
            [&](Point p) { return colour * (0.6 + 0.8 * cloth(p.x - joints.hip.x, p.y - joints.hip.y)); });
    };
    const auto leg = [&](std::size_t side, double shade) {
        part(joints.hip, joints.knee[side], 0.062, 0.045, trousers * shade);
        part(joints.knee[side], joints.foot[side], 0.045, 0.030, trousers * shade);
        const Point toe{joints.foot[side].x + figure.facing * 0.06 * h, joints.foot[side].y + 0.008 * h};
        part(joints.foot[side], toe, 0.026, 0.018, Colour{0.06, 0.06, 0.07} * shade);
    };
    const auto upper_limb = [&](std::size_t side, double shade) {
        part(joints.shoulder, joints.elbow[side], 0.045, 0.036, coat * shade);
        part(joints.elbow[side], joints.hand[side], 0.036, 0.026, coat * shade);
        part(joints.hand[side], joints.hand[side], 0.028, 0.028, skin * shade);
    };
    upper_limb(1, 0.7);
    leg(1, 0.7);
    leg(0, 1);
    const Point waist{joints.hip.x, joints.hip.y - 0.01 * h};
    const Point chest = joints.shoulder + (joints.hip - joints.shoulder) * 0.12;
    part(waist, chest, 0.082, 0.096, coat);
    part(joints.shoulder, joints.head, 0.034, 0.034, skin * 0.8);
    part(joints.head, joints.head, 0.070, 0.070, skin);
    const Point crown{joints.head.x - figure.facing * 0.018 * h, joints.head.y - 0.022 * h};
    part(crown, crown, 0.066, 0.066, hair);
    const Point face{joints.head.x + figure.facing * 0.030 * h, joints.head.y + 0.012 * h};
    part(face, face, 0.042, 0.042, skin);
    upper_limb(0, 0.95);
}

Point middle_of_bag(Point handle, double height) {
    return {handle.x, handle.y + 0.14 * height};
}

void paint_bag(Canvas& canvas, Point handle, double height) {
    const Texture leather(777, 3, 9);
    const Point middle = middle_of_bag(handle, height);
    const Point half{0.13 * height, 0.09 * height};
    const Colour red{0.10, 0.14, 0.62};
    const Point top{handle.x, middle.y - half.y};
    const auto ring = [&](Point p) {
        return std::abs(length_of(p.x - top.x, (p.y - top.y) * 1.2) - 0.06 * height) - 0.011 * height;
    };
    canvas.paint(top, 0.1 * height, ring, Colour{0.05, 0.05, 0.08});
    canvas.paint(
        middle, half.x + 1, [&](Point p) { return round_box(p, middle, half, 0.025 * height); },
        [&](Point p) {
            const double stripe = std::abs(p.y - middle.y) < 0.016 * height ? 0.5 : 1;
            return red * (stripe * (0.65 + 0.7 * leather(p.x - middle.x, p.y - middle.y)));
        });
}

}  // namespace vvr::generator
