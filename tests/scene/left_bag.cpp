#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "tests/scene/hall_story.h"

namespace vvr::generator {
namespace {

// The stories' own frames and pixels: 1600 or 800 frames of 384x288.
constexpr double bag_frames = 1600;
constexpr double box_frames = 800;
constexpr double speed = 1.3;  // pixels per frame
constexpr double place = 205;  // where the person stops
constexpr double outside = 40;
constexpr double enters = 150;
constexpr double stops = enters + (place + outside) / speed;
constexpr double puts_down = stops + 15;
constexpr double goes = stops + 30;
constexpr double comes_back = 1130;
// Whoever leaves the box for good walks around it first: so far to the right, then to the left of it.
constexpr double beyond = 60;
constexpr double before = 80;
constexpr double turns_back = goes + beyond / speed;
constexpr double turns_away = turns_back + (beyond + before) / speed;

enum class Ending { taken_up, left };

class LeftBagStory final : public HallStory {
  public:
    LeftBagStory(const Options& options, Ending ending)
        : HallStory(options, ending == Ending::left ? box_frames : bag_frames), ending_(ending) {}

    Plane<Bgr> paint(int frame) const override {
        auto picture = hall_;
        Canvas canvas(&picture);
        paint_bag_of(canvas, frame, true);
        if (const auto figure = figure_at(frame * time_scale_)) {
            paint_shadow(canvas, figure->feet, 0.26 * figure->height);
            paint_figure(canvas, *figure);
            if (is_carried(frame * time_scale_)) paint_bag(canvas, handle_at(frame * time_scale_), figure->height);
        }
        return picture;
    }

    Truth truth(int frame) const override {
        Truth truth;
        const double now = frame * time_scale_;
        const double next = (frame + 1) * time_scale_;
        Object bag{"bag", 0, 0, 0, 0, Plane<std::uint8_t>(hall_.size())};
        Canvas bag_canvas(nullptr, &bag.mask);
        if (const auto figure = figure_at(now)) {
            const auto after = figure_at(next);
            const Point middle = middle_of(*figure);
            Object person{"person", middle.x,
                          middle.y, after ? middle_of(*after).x - middle.x : 0,
                          0,        Plane<std::uint8_t>(hall_.size())};
            Canvas canvas(nullptr, &person.mask);
            paint_figure(canvas, *figure);
            if (is_carried(now)) paint_bag(bag_canvas, handle_at(now), figure->height);
            // Whoever stands in front hides the other.
            paint_bag_of(bag_canvas, frame, false);
            Plane<std::uint8_t>& behind = is_carried(now) ? person.mask : bag.mask;
            const Plane<std::uint8_t>& front = is_carried(now) ? bag.mask : person.mask;
            for (std::size_t i = 0; i < behind.pixels().size(); ++i)
                if (front.pixels()[i]) behind.pixels()[i] = 0;
            truth.objects.push_back(std::move(person));
        } else {
            paint_bag_of(bag_canvas, frame, false);
        }
        if (is_there(now)) {
            const Point middle = middle_of_bag(handle_at(now), height());
            const Point after = middle_of_bag(handle_at(next), height());
            bag.x = middle.x;
            bag.y = middle.y;
            if (is_there(next)) {
                bag.vx = after.x - middle.x;
                bag.vy = after.y - middle.y;
            }
            truth.objects.push_back(std::move(bag));
        }
        return truth;
    }

    LeftBag facts() const {
        const Point middle = middle_of_bag(standing_handle(), height());
        return {static_cast<int>(std::ceil(puts_down / time_scale_)),
                static_cast<int>(std::ceil(takes_up() / time_scale_)), middle.x, middle.y};
    }

  private:
    double arrives() const { return comes_back + (width_ + outside - place) / speed; }
    double takes_up() const { return arrives() + 15; }

    bool stands(double now) const { return now >= puts_down && (ending_ == Ending::left || now < takes_up()); }
    bool is_carried(double now) const { return !stands(now) && figure_at(now).has_value(); }
    bool is_there(double now) const { return stands(now) || is_carried(now); }

    /// Nothing while nobody is to be seen.
    std::optional<Figure> figure_at(double now) const {
        const double turns = arrives() + 30;
        if (now >= enters && now < stops) return walking(-outside + (now - enters) * speed, 1);
        if (now >= stops && now < goes) return standing(1, (now - stops) / (goes - stops));
        if (now >= goes && ending_ == Ending::left) return around(now);
        if (now >= goes && now < goes + (width_ + outside - place) / speed)
            return walking(place + (now - goes) * speed, 1);
        if (now >= comes_back && now < arrives()) return walking(width_ + outside - (now - comes_back) * speed, -1);
        if (now >= arrives() && now < turns) return standing(-1, (now - arrives()) / (turns - arrives()));
        if (now >= turns && now < turns + (place + outside) / speed) return walking(place - (now - turns) * speed, -1);
        return std::nullopt;
    }

    std::optional<Figure> around(double now) const {
        if (now < turns_back) return walking(place + (now - goes) * speed, 1);
        if (now < turns_away) return walking(place + beyond - (now - turns_back) * speed, -1);
        const double x = place - before + (now - turns_away) * speed;
        return x < width_ + outside ? std::optional(walking(x, 1)) : std::nullopt;
    }

    Figure walking(double x, double facing) const {
        // A step is as long as two fifths of the body.
        const double stride = std::abs(x - place) * scale_ / (0.8 * height()) * 2 * std::numbers::pi;
        return {{x * scale_, floor()}, height(), stride, facing, 1, 0, 0, seed_ + 3};
    }

    Figure standing(double facing, double part) const {
        return {{place * scale_, floor()}, height(), 0, facing, 0, std::sin(part * std::numbers::pi), 0, seed_ + 3};
    }

    /// The bag stands just where the hand is when it is lowest.
    Point standing_handle() const {
        const Point hand = hand_of(standing(1, 0.5));
        return {hand.x, floor() - 0.23 * height()};
    }

    Point handle_at(double now) const {
        const auto figure = figure_at(now);
        if (stands(now) || !figure) return standing_handle();
        const Point hand = hand_of(*figure);
        return {hand.x, std::min(hand.y, standing_handle().y)};
    }

    void paint_bag_of(Canvas& canvas, int frame, bool with_shadow) const {
        if (!stands(frame * time_scale_)) return;
        const Point handle = standing_handle();
        if (with_shadow) paint_shadow(canvas, {handle.x, floor()}, 0.2 * height());
        paint_bag(canvas, handle, height());
    }

    Ending ending_;
};

}  // namespace

Scene make_left_bag(const Options& options) {
    const auto all = with_frames(options, bag_frames);
    return {all, std::make_shared<LeftBagStory>(all, Ending::taken_up)};
}

Scene make_left_box(const Options& options) {
    const auto all = with_frames(options, box_frames);
    return {all, std::make_shared<LeftBagStory>(all, Ending::left)};
}

LeftBag left_bag_facts(const Options& options) {
    return LeftBagStory(with_frames(options, bag_frames), Ending::taken_up).facts();
}

}  // namespace vvr::generator
