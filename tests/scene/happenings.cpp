#include "tests/scene/happenings.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/scene/actors.h"
#include "tests/scene/canvas.h"
#include "tests/scene/figure.h"
#include "tests/scene/texture.h"

namespace vvr::generator {
namespace {

constexpr int crossings = 10;
constexpr double crossing_frames = 50;

Scene make_crowd_of(const Options& options, int frames) {
    constexpr int between = 35;  // frames from one person to the next
    constexpr int begins = -100;
    std::vector<Actor> actors;
    for (int k = 0; k < (frames - begins) / between; ++k) {
        const double speed = (k % 2 == 0 ? 1 : -1) * (0.9 + 0.1 * (k % 5));
        const double floor = 84 + 4 * ((k * 5) % 14);
        actors.push_back(walker("person " + std::to_string(k), options,
                                {across(begins + between * k, speed, floor), static_cast<std::uint64_t>(20 + k)}));
    }
    return make_happening(options, frames, std::move(actors));
}

}  // namespace

Scene make_ten_crossings(const Options& options) {
    const auto pacing = [](double direction, double floor) -> Way {
        return [=](double frame) -> std::optional<Point> {
            const double begin = crossing_frames / 2;
            const double end = begin + crossing_frames * crossings;
            double x = 0;
            if (frame < begin) {
                x = 1 - (begin - frame) * 2 / crossing_frames * 1.6;
                x = std::min(x, 1.0);
            } else if (frame < end) {
                const double phase = std::fmod((frame - begin) / crossing_frames, 2.0);
                x = phase < 1 ? 1 - 2 * phase : 2 * phase - 3;
            } else {
                return std::nullopt;
            }
            return Point{story_width / 2 + direction * 70 * x, floor};
        };
    };
    return make_happening(
        options, static_cast<int>(crossing_frames * crossings) + 30,
        {walker("person 0", options, {pacing(1, 112), 3}), walker("person 1", options, {pacing(-1, 120), 8})});
}

Scene make_group_splits(const Options& options) {
    const Way turns = [](double frame) -> std::optional<Point> {
        const double turn = 140;
        const double x = -10 + (frame < turn ? frame : 2 * turn - frame) * 0.8;
        return x < -person / 2 ? std::nullopt : std::optional(Point{x, 118});
    };
    const Way goes_on = [](double frame) -> std::optional<Point> {
        const double x = 2 + frame * 0.8;
        return x > story_width + person / 2 ? std::nullopt : std::optional(Point{x, 116});
    };
    return make_happening(options, 300,
                          {walker("person 1", options, {goes_on, 5}), walker("person 0", options, {turns, 12})});
}

Interval train_stands() {
    return {100, 360};
}

Scene make_train(const Options& options) {
    const double scale = scale_of(options);
    const auto middle = [](double frame) -> std::optional<Point> {
        const Interval stands = train_stands();
        const double before = std::max(0.0, stands.first - frame);
        const double after = std::max(0.0, frame - stands.last);
        const double x = 80 + before * 2.5 - after * 2.5;
        return x > story_width + 70 || x < -70 ? std::nullopt : std::optional(Point{x, 62});
    };
    const Actor train{"train", middle, [=](Canvas& canvas, double frame) {
                          const Point m = *middle(frame) * scale;
                          const Point half{70 * scale, 26 * scale};
                          const auto distance = [=](Point p) {
                              const double x = (p.x - m.x) / scale;
                              const double y = (p.y - m.y) / scale;
                              const double body = round_box(p, m, half, 3 * scale);
                              const double column = std::fmod(std::abs(x + 70), 28.0);
                              const bool window = y > -18 && y < 4 && column > 5 && column < 23;
                              const bool gap = std::abs(x - 14) < 2;  // between two cars
                              return window || gap ? 1.0 : body;
                          };
                          canvas.paint(m, half.x + half.y, distance, Colour{0.75, 0.55, 0.2});
                      }};
    return make_happening(options, 500, {train, walker("person", options, {across(150, 1.2, 130), 7})});
}

Interval pale_bag_stands() {
    return {130, 399};
}

Scene make_pale_bag(const Options& options) {
    return make_happening(
        options, 400,
        {box("bag", options, at_place({76, 108}, pale_bag_stands()), {7, 11}, {0.58, 0.62, 0.68}, 2),
         walker("person", options, {with_stop(92, 110, 150, 1.1, 118), 4, double(pale_bag_stands().first)})});
}

Interval box_is_gone() {
    return {230, 399};
}

Scene make_taken_box(const Options& options) {
    return make_happening(
        options, 400,
        {box("box", options, at_place({78, 108}, {0, box_is_gone().first - 1}), {8, 8}, {0.1, 0.25, 0.7}),
         walker("person", options, {with_stop(94, 210, 250, 1.1, 118), 6, double(box_is_gone().first)})});
}

Scene make_rain(const Options& options) {
    const double scale = scale_of(options);
    const Actor rain{"rain", [](double) { return std::optional(Point{}); },
                     [=, seed = options.seed](Canvas& canvas, double frame) {
                         for (std::uint64_t k = 0; k < 25; ++k) {
                             const std::uint64_t drop = seed * 7919 + static_cast<std::uint64_t>(frame) * 131 + k * 3;
                             const Point top{unit(drop) * story_width * scale, unit(drop + 1) * story_height * scale};
                             const Point foot{top.x + 1, top.y + 9 * scale};
                             const auto streak = [&](Point p) { return limb(p, top, foot, 0.8, 0.8); };
                             canvas.paint(top, 12 * scale, streak, Colour{0.8, 0.8, 0.8});
                         }
                     }};
    return make_happening(options, 250, {walker("person", options, {across(20, 1.2, 116), 2}), rain});
}

Scene make_crowd(const Options& options) {
    return make_crowd_of(options, 400);
}

Scene make_long_crowd(const Options& options) {
    return make_crowd_of(options, 1500);
}

Interval long_stand() {
    return {100, 400};
}

Scene make_stands_long(const Options& options) {
    const Interval stands = long_stand();
    return make_happening(options, 500,
                          {walker("person", options, {with_stop(90, stands.first, stands.last, 1.3, 118), 9})});
}

Scene make_walks_by(const Options& options) {
    return make_happening(options, 250, {walker("person", options, {across(30, 1.2, 116), 2})});
}

Scene make_stands(const Options& options) {
    return make_happening(options, 350, {walker("person", options, {with_stop(90, 90, 290, 1.3, 118), 9})});
}

Scene make_comes_closer(const Options& options) {
    const double scale = scale_of(options);
    constexpr double begins = 30;
    constexpr double takes = 190;
    const auto height = [](double frame) { return 20 * std::pow(8.5, (frame - begins) / takes); };
    const auto feet = [=](double frame) -> std::optional<Point> {
        if (frame < begins || frame > begins + takes) return std::nullopt;
        // Whoever walks straight ahead grows and goes away from the point at which parallel ways meet, in proportion.
        return Point{60 + height(frame), 55 + 1.1 * height(frame)};
    };
    const Actor person_near{"person",
                            [=](double frame) -> std::optional<Point> {
                                const auto at = feet(frame);
                                if (!at) return std::nullopt;
                                return Point{at->x, at->y - height(frame) / 2};
                            },
                            [=](Canvas& canvas, double frame) {
                                const Point floor = *feet(frame) * scale;
                                const double tall = height(frame) * scale;
                                paint_shadow(canvas, floor, 0.26 * tall);
                                paint_figure(canvas, {.feet = floor,
                                                      .height = tall,
                                                      .stride = frame / 25 * 2 * std::numbers::pi,
                                                      .facing = 1,
                                                      .gait = 0.4,
                                                      .bow = 0,
                                                      .fall = 0,
                                                      .seed = options.seed + 6});
                            }};
    return make_happening(options, 250, {person_near});
}

}  // namespace vvr::generator
