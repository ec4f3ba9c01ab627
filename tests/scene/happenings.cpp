#include "tests/scene/happenings.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/scene/canvas.h"
#include "tests/scene/figure.h"
#include "tests/scene/texture.h"

namespace vvr::generator {
namespace {

// The stories are told on a picture of this height; a larger one is the same, enlarged.
constexpr double story_height = 144;
constexpr double story_width = 192;
constexpr double person = 48;  // story pixels

constexpr int crossings = 10;
constexpr double crossing_frames = 50;

/// Something that is drawn: by its name, and as a function of the frame on a canvas.
struct Actor {
    std::string name;
    std::function<std::optional<Point>(double frame)> middle;  ///< nothing while it is not there
    std::function<void(Canvas& canvas, double frame)> paint;
};

class Happening final : public Story {
  public:
    Happening(const Options& options, std::vector<Actor> actors)
        : scale_(options.size.height / story_height),
          hall_(paint_hall(options.size, options.seed, options.detail)),
          actors_(std::move(actors)) {}

    Plane<Bgr> paint(int frame) const override {
        auto picture = hall_;
        Canvas canvas(&picture);
        for (const Actor& actor : actors_) {
            if (actor.middle(frame)) actor.paint(canvas, frame);
        }
        return picture;
    }

    Truth truth(int frame) const override {
        Truth truth;
        for (const Actor& actor : actors_) {
            const std::optional<Point> middle = actor.middle(frame);
            if (!middle) continue;
            Plane<std::uint8_t> mask(hall_.size());
            Canvas canvas(nullptr, &mask);
            actor.paint(canvas, frame);
            const Point next = actor.middle(frame + 1).value_or(*middle);
            truth.objects.push_back({actor.name, middle->x * scale_, middle->y * scale_, (next.x - middle->x) * scale_,
                                     (next.y - middle->y) * scale_, std::move(mask)});
        }
        return truth;
    }

  private:
    double scale_;
    Plane<Bgr> hall_;
    std::vector<Actor> actors_;
};

double scale_of(const Options& options) {
    return options.size.height / story_height;
}

/// Where somebody's feet are at a frame; nothing while there is nobody.
using Way = std::function<std::optional<Point>(double frame)>;

Actor walker(std::string name, const Options& options, std::uint64_t seed, Way way, double bow_at = -1) {
    const double scale = scale_of(options);
    return {std::move(name),
            [way](double frame) -> std::optional<Point> {
                const auto feet = way(frame);
                if (!feet) return std::nullopt;
                return Point{feet->x, feet->y - person / 2};
            },
            [=](Canvas& canvas, double frame) {
                const Point feet = *way(frame);
                const Point next = way(frame + 1).value_or(feet);
                const double speed = std::abs(next.x - feet.x);
                const double bow = bow_at < 0 ? 0 : std::max(0.0, 1 - std::abs(frame - bow_at) / 15);
                paint_figure(canvas, {.feet = {feet.x * scale, feet.y * scale},
                                      .height = person * scale,
                                      .stride = feet.x / (0.8 * person) * 2 * std::numbers::pi,
                                      .facing = next.x < feet.x ? -1.0 : 1.0,
                                      .gait = std::min(1.0, speed),
                                      .bow = bow,
                                      .fall = 0,
                                      .seed = options.seed + seed});
            }};
}

/// From one side of the picture to the other, with `speed` story pixels per frame; negative = to the left.
Way across(double enters, double speed, double floor) {
    return [=](double frame) -> std::optional<Point> {
        const double walked = (frame - enters) * std::abs(speed) - person / 2;
        if (walked < -person / 2 || walked > story_width + person / 2) return std::nullopt;
        return Point{speed > 0 ? walked : story_width - walked, floor};
    };
}

/// To a place, where it stops from `arrives` to `leaves`, and on.
Way with_stop(double place, double arrives, double leaves, double speed, double floor) {
    return [=](double frame) -> std::optional<Point> {
        const double moved = frame < arrives ? frame - arrives : std::max(0.0, frame - leaves);
        const double x = place + moved * speed;
        if (x < -person / 2 || x > story_width + person / 2) return std::nullopt;
        return Point{x, floor};
    };
}

Actor box(std::string name, const Options& options, Point middle, Point half, Colour colour, Interval there,
          int stripes = 0) {
    const double scale = scale_of(options);
    return {std::move(name),
            [=](double frame) -> std::optional<Point> {
                return frame >= there.first && frame <= there.last ? std::optional(middle) : std::nullopt;
            },
            [=](Canvas& canvas, double) {
                const Point m{middle.x * scale, middle.y * scale};
                const Point h{half.x * scale, half.y * scale};
                const auto distance = [=](Point p) {
                    const double whole = round_box(p, m, h, scale);
                    if (stripes == 0) return whole;
                    // Stripes of it are as the floor is.
                    const double part = (p.y - m.y + h.y) / (2 * h.y) * (2 * stripes - 1);
                    return static_cast<int>(std::floor(part)) % 2 != 0 ? 1.0 : whole;
                };
                canvas.paint(m, h.x + h.y, distance, [=](Point) { return colour; });
            }};
}

Scene make(Options options, int frames, std::vector<Actor> actors) {
    options.frames = frames;
    return {options, std::make_shared<Happening>(options, std::move(actors))};
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
    return make(options, static_cast<int>(crossing_frames * crossings) + 30,
                {walker("person 0", options, 3, pacing(1, 112)), walker("person 1", options, 8, pacing(-1, 120))});
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
    return make(options, 300, {walker("person 1", options, 5, goes_on), walker("person 0", options, 12, turns)});
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
                          const Point m{middle(frame)->x * scale, middle(frame)->y * scale};
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
                          canvas.paint(m, half.x + half.y, distance, [](Point) { return Colour{0.75, 0.55, 0.2}; });
                      }};
    return make(options, 500, {train, walker("person", options, 7, across(150, 1.2, 130))});
}

Interval pale_bag_stands() {
    return {130, 399};
}

Scene make_pale_bag(const Options& options) {
    return make(options, 400,
                {box("bag", options, {76, 108}, {7, 11}, {0.58, 0.62, 0.68}, pale_bag_stands(), 2),
                 walker("person", options, 4, with_stop(92, 110, 150, 1.1, 118), pale_bag_stands().first)});
}

Interval box_is_gone() {
    return {230, 399};
}

Scene make_taken_box(const Options& options) {
    return make(options, 400,
                {box("box", options, {78, 108}, {8, 8}, {0.1, 0.25, 0.7}, {0, box_is_gone().first - 1}),
                 walker("person", options, 6, with_stop(94, 210, 250, 1.1, 118), box_is_gone().first)});
}

Scene make_rain(const Options& options) {
    const double scale = scale_of(options);
    const Actor rain{"rain", [](double) { return std::optional(Point{}); },
                     [=, seed = options.seed](Canvas& canvas, double frame) {
                         for (std::uint64_t k = 0; k < 25; ++k) {
                             const std::uint64_t drop = seed * 7919 + static_cast<std::uint64_t>(frame) * 131 + k * 3;
                             const Point top{unit(drop) * story_width * scale, unit(drop + 1) * story_height * scale};
                             const Point foot{top.x + 1, top.y + 9 * scale};
                             canvas.paint(
                                 top, 12 * scale, [&](Point p) { return limb(p, top, foot, 0.8, 0.8); },
                                 [](Point) {
                                     return Colour{0.8, 0.8, 0.8};
                                 });
                         }
                     }};
    return make(options, 250, {walker("person", options, 2, across(20, 1.2, 116)), rain});
}

Scene make_crowd(const Options& options) {
    std::vector<Actor> actors;
    for (int k = 0; k < 14; ++k) {
        const double speed = (k % 2 == 0 ? 1 : -1) * (0.9 + 0.1 * (k % 5));
        const double floor = 84 + 4 * ((k * 5) % 14);
        actors.push_back(walker("person " + std::to_string(k), options, static_cast<std::uint64_t>(20 + k),
                                across(-100 + 35 * k, speed, floor)));
    }
    return make(options, 400, std::move(actors));
}

Interval long_stand() {
    return {100, 400};
}

Scene make_stands_long(const Options& options) {
    const Interval stands = long_stand();
    return make(options, 500, {walker("person", options, 9, with_stop(90, stands.first, stands.last, 1.3, 118))});
}

Scene make_clock(const Options& options) {
    const double scale = scale_of(options);
    const Actor clock{"clock",
                      [](double) {
                          return std::optional(Point{150, 8});
                      },
                      [=](Canvas& canvas, double frame) {
                          const int seconds = static_cast<int>(frame) / 25;
                          for (int digit = 0; digit < 6; ++digit) {
                              const int value = digit == 5 ? seconds % 10 : digit == 4 ? seconds / 10 + 1 : 3;
                              for (int bar = 0; bar < 5; ++bar) {
                                  if (((value * 13 + 5) >> bar) % 2 == 0) continue;
                                  const Point m{(122 + 8 * digit + (bar % 2) * 3) * scale, (5 + bar * 2) * scale};
                                  canvas.paint(
                                      m, 4 * scale,
                                      [&](Point p) {
                                          return round_box(p, m, {2 * scale, 1 * scale}, 0);
                                      },
                                      [](Point) {
                                          return Colour{1, 1, 1};
                                      });
                              }
                          }
                      }};
    return make(options, 300, {clock});
}

Scene make_walks_by(const Options& options) {
    return make(options, 250, {walker("person", options, 2, across(30, 1.2, 116))});
}

Scene make_stands(const Options& options) {
    return make(options, 350, {walker("person", options, 9, with_stop(90, 90, 290, 1.3, 118))});
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
                                const Point at = *feet(frame);
                                const Point floor{at.x * scale, at.y * scale};
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
    return make(options, 250, {person_near});
}

}  // namespace vvr::generator
