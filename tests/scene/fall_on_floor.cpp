#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "tests/scene/hall_story.h"

namespace vvr::generator {
namespace {

// The story's own frames and pixels: 600 frames of 384x288.
constexpr double fall_frames = 600;
constexpr double fall_speed = 1.6;  // pixels per frame
constexpr double fall_place = 150;  // where the person falls
constexpr double fall_outside = 50;
constexpr double fall_enters = 30;
constexpr double falls = fall_enters + (fall_place + fall_outside) / fall_speed;
constexpr double lies = falls + 14;
constexpr double gets_up = 360;
constexpr double fall_goes = gets_up + 40;
constexpr double flat = std::numbers::pi / 2;

class FallStory final : public HallStory {
  public:
    explicit FallStory(const Options& options) : HallStory(options, fall_frames) {}

    Plane<Bgr> paint(int frame) const override {
        auto picture = hall_;
        if (const auto figure = figure_at(frame * time_scale_)) {
            Canvas canvas(&picture);
            const Point middle = middle_of(*figure);
            const double lying = figure->fall / flat;
            paint_shadow(canvas, {figure->feet.x + (middle.x - figure->feet.x) * lying, figure->feet.y},
                         (0.26 + 0.3 * lying) * figure->height);
            paint_figure(canvas, *figure);
        }
        return picture;
    }

    Truth truth(int frame) const override {
        Truth truth;
        const auto figure = figure_at(frame * time_scale_);
        if (!figure) return truth;
        const Point middle = middle_of(*figure);
        const auto after = figure_at((frame + 1) * time_scale_);
        const Point next = after ? middle_of(*after) : middle;
        Object person{"person",          middle.x,          middle.y,
                      next.x - middle.x, next.y - middle.y, Plane<std::uint8_t>(hall_.size())};
        Canvas canvas(nullptr, &person.mask);
        paint_figure(canvas, *figure);
        truth.objects.push_back(std::move(person));
        return truth;
    }

    FallOnFloor facts() const {
        const auto first = [&](double time) { return static_cast<int>(std::ceil(time / time_scale_)); };
        const Point middle = middle_of(*figure_at(lies));
        return {first(falls), first(lies), first(gets_up), middle.x, middle.y};
    }

  private:
    /// Nothing while nobody is to be seen.
    std::optional<Figure> figure_at(double now) const {
        if (now < fall_enters) return std::nullopt;
        if (now < falls) return walking(-fall_outside + (now - fall_enters) * fall_speed);
        if (now < gets_up) {
            // Faster and faster, as things fall.
            const double part = std::min((now - falls) / (lies - falls), 1.0);
            return tipped(part * part);
        }
        if (now < fall_goes) return tipped(1 - (now - gets_up) / (fall_goes - gets_up));
        const double x = fall_place + (now - fall_goes) * fall_speed;
        return x < width_ + fall_outside ? std::optional(walking(x)) : std::nullopt;
    }

    Figure walking(double x) const {
        const double stride = std::abs(x - fall_place) * scale_ / (0.8 * height()) * 2 * std::numbers::pi;
        return {{x * scale_, floor()}, height(), stride, 1, 1, 0, 0, seed_ + 5};
    }

    Figure tipped(double part) const {
        return {{fall_place * scale_, floor()}, height(), 0, 1, 1 - part, 0, part * flat, seed_ + 5};
    }
};

}  // namespace

Scene make_fall_on_floor(const Options& options) {
    const auto all = with_frames(options, fall_frames);
    return {all, std::make_shared<FallStory>(all)};
}

FallOnFloor fall_on_floor_facts(const Options& options) {
    return FallStory(with_frames(options, fall_frames)).facts();
}

}  // namespace vvr::generator
