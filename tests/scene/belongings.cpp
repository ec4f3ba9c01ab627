// Scenes of people who wait, and of what they put down.
#include <algorithm>
#include <cstdint>
#include <optional>

#include "tests/scene/actors.h"

namespace vvr::generator {
namespace {

constexpr double sway = 0.05;  // radians: the head of somebody who stands moves by two pixels

/// A bag that `bringer` carries until he puts it down, and `taker` carries from when he takes it.
Actor carried_bag(const Options& options, const Person& bringer, const Person& taker) {
    const double scale = scale_of(options);
    const double tall = person * scale;
    const Figure stoops = figure_of(options, bringer, bringer.bow_at);
    const Point handle{hand_of(stoops).x, stoops.feet.y - 0.23 * tall};
    // Where its handle is, in pixels.
    const auto handle_at = [=](double frame) -> std::optional<Point> {
        const bool stands = frame >= bringer.bow_at && frame < taker.bow_at;
        if (stands) return handle;
        const Person& bearer = frame < bringer.bow_at ? bringer : taker;
        if (!bearer.feet(frame)) return std::nullopt;
        const Point hand = hand_of(figure_of(options, bearer, frame));
        return Point{hand.x, std::min(hand.y, handle.y)};
    };
    return {"bag",
            [=](double frame) -> std::optional<Point> {
                const auto at = handle_at(frame);
                return at ? std::optional(middle_of_bag(*at, tall) * (1 / scale)) : std::nullopt;
            },
            [=](Canvas& canvas, double frame) { paint_bag(canvas, *handle_at(frame), tall); }};
}

}  // namespace

Interval minute_of_waiting() {
    return {625, 2125};
}

Scene make_waits(const Options& options) {
    const Interval waits = minute_of_waiting();
    return make_happening(options, 2375,
                          {walker("person", options, {with_stop(90, waits.first, waits.last, 1.2, 118), 9, -1, sway})});
}

Scene make_waits_early(const Options& options) {
    constexpr int comes = 100;
    const int goes = comes + minute_of_waiting().last - minute_of_waiting().first;
    return make_happening(options, 1750,
                          {walker("person", options, {with_stop(90, comes, goes, 1.2, 118), 9, -1, sway})});
}

Scene make_people_from_first(const Options& options, int frames) {
    constexpr int goes = 250;
    return make_happening(options, frames,
                          {walker("person 0", options, {with_stop(40, -1, goes, -1.1, 112), 3, -1, sway}),
                           walker("person 1", options, {with_stop(96, -1, goes + 12, 1.0, 122), 8, -1, sway}),
                           walker("person 2", options, {with_stop(150, -1, goes - 10, 1.2, 116), 12, -1, sway})});
}

Interval faint_bag_stands() {
    return {150, 449};
}

Scene make_faint_bag(const Options& options) {
    constexpr double levels = 30;
    const double scale = scale_of(options);
    const Point middle{72, 108};
    const Actor bag{"bag", at_place(middle, faint_bag_stands()),
                    [=, hall = paint_hall(options.size, options.seed, options.detail)](Canvas& canvas, double) {
                        const Point m = middle * scale;
                        const Point half{8 * scale, 10 * scale};
                        const auto paler = [](std::uint8_t value) { return std::min(1.0, (value + levels) / 255); };
                        canvas.paint(
                            m, half.x + half.y, [&](Point p) { return round_box(p, m, half, 2 * scale); },
                            [&](Point p) {
                                const Bgr floor = hall.at(static_cast<int>(p.x), static_cast<int>(p.y));
                                return Colour{paler(floor[0]), paler(floor[1]), paler(floor[2])};
                            });
                    }};
    const int put_down = faint_bag_stands().first;
    return make_happening(
        options, 450,
        {bag, walker("person", options,
                     {with_stop(92, put_down - 20, put_down + 20, 1.1, 118), 4, static_cast<double>(put_down)})});
}

Interval bag_of_two_stands() {
    return {170, 569};
}

Scene make_bag_of_two(const Options& options) {
    const Interval stands = bag_of_two_stands();
    const int taken = stands.last + 1;
    const Person bringer{with_stop(84, stands.first - 15, stands.first + 15, 1.1, 118), 4,
                         static_cast<double>(stands.first)};
    const Person taker{with_stop(84, taken - 15, taken + 15, -1.2, 118), 11, static_cast<double>(taken)};
    return make_happening(options, 800,
                          {walker("person 0", options, bringer), walker("person 1", options, taker),
                           carried_bag(options, bringer, taker)});
}

}  // namespace vvr::generator
