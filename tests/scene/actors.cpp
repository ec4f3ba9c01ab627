#include "tests/scene/actors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tests/scene/texture.h"

namespace vvr::generator {
namespace {

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
            const Point at = *middle * scale_;
            const Point way = (actor.middle(frame + 1).value_or(*middle) - *middle) * scale_;
            truth.objects.push_back({actor.name, at.x, at.y, way.x, way.y, std::move(mask)});
        }
        return truth;
    }

  private:
    double scale_;
    Plane<Bgr> hall_;
    std::vector<Actor> actors_;
};

}  // namespace

double scale_of(const Options& options) {
    return options.size.height / story_height;
}

double wander(double frame, double period, std::uint64_t seed) {
    double sum = 0;
    for (std::uint64_t k = 0; k < 3; ++k) {
        const double phase = unit(seed * 5 + k);
        sum += std::sin(2 * std::numbers::pi * (frame / period * std::pow(1.83, static_cast<double>(k)) + phase));
    }
    return sum / 3;
}

Figure figure_of(const Options& options, const Person& who, double frame) {
    const double scale = scale_of(options);
    const Point feet = *who.feet(frame);
    const Point next = who.feet(frame + 1).value_or(feet);
    const double speed = std::abs(next.x - feet.x);
    return {.feet = feet * scale,
            .height = person * scale,
            .stride = feet.x / (0.8 * person) * 2 * std::numbers::pi,
            .facing = next.x < feet.x ? -1.0 : 1.0,
            .gait = std::min(1.0, speed),
            .bow = who.bow_at < 0 ? 0 : std::max(0.0, 1 - std::abs(frame - who.bow_at) / 15),
            .fall = speed > 0 ? 0 : who.sway * wander(frame, 110, options.seed + who.seed),
            .seed = options.seed + who.seed};
}

Actor walker(std::string name, const Options& options, Person who) {
    return {std::move(name),
            [feet = who.feet](double frame) -> std::optional<Point> {
                const auto at = feet(frame);
                return at ? std::optional(*at - Point{0, person / 2}) : std::nullopt;
            },
            [=](Canvas& canvas, double frame) { paint_figure(canvas, figure_of(options, who, frame)); }};
}

Way across(double enters, double speed, double floor) {
    return [=](double frame) -> std::optional<Point> {
        const double walked = (frame - enters) * std::abs(speed) - person / 2;
        if (walked < -person / 2 || walked > story_width + person / 2) return std::nullopt;
        return Point{speed > 0 ? walked : story_width - walked, floor};
    };
}

Way with_stop(double place, double arrives, double leaves, double speed, double floor) {
    return [=](double frame) -> std::optional<Point> {
        const double moved = frame < arrives ? frame - arrives : std::max(0.0, frame - leaves);
        const double x = place + moved * speed;
        if (x < -person / 2 || x > story_width + person / 2) return std::nullopt;
        return Point{x, floor};
    };
}

Way at_place(Point place, Interval there) {
    return [=](double frame) -> std::optional<Point> {
        return frame >= there.first && frame <= there.last ? std::optional(place) : std::nullopt;
    };
}

Actor box(std::string name, const Options& options, Way middle, Point half, Colour colour, int stripes) {
    const double scale = scale_of(options);
    return {std::move(name), middle, [=](Canvas& canvas, double frame) {
                const Point m = *middle(frame) * scale;
                const Point h = half * scale;
                const auto distance = [=](Point p) {
                    const double whole = round_box(p, m, h, scale);
                    if (stripes == 0) return whole;
                    // Stripes of it are as the floor is.
                    const double part = (p.y - m.y + h.y) / (2 * h.y) * (2 * stripes - 1);
                    return static_cast<int>(std::floor(part)) % 2 != 0 ? 1.0 : whole;
                };
                canvas.paint(m, h.x + h.y, distance, colour);
            }};
}

Scene make_happening(Options options, int frames, std::vector<Actor> actors) {
    options.frames = frames;
    return {options, std::make_shared<Happening>(options, std::move(actors))};
}

}  // namespace vvr::generator
