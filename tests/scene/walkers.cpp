#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "tests/scene/hall_story.h"

namespace vvr::generator {
namespace {

constexpr double walk_frames = 600;

struct Walker {
    double enters;  // story frame
    double speed;   // story pixels per frame, to the right
    double floor;   // story pixels from the top
    double height;  // story pixels
};

// By distance, the farthest first, as they are painted.
constexpr std::array many{Walker{20, 0.8, 170, 62},  Walker{240, -0.9, 178, 64}, Walker{60, -1.2, 205, 78},
                          Walker{180, 1.5, 222, 88}, Walker{330, 1.1, 246, 98},  Walker{120, -2.0, 266, 106}};
constexpr std::array two{Walker{80, 1.2, 205, 78}, Walker{60, -1.1, 246, 98}};

class WalkersStory final : public HallStory {
  public:
    WalkersStory(const Options& options, std::span<const Walker> walkers)
        : HallStory(options, walk_frames), walkers_(walkers) {}

    Plane<Bgr> paint(int frame) const override {
        auto picture = hall_;
        Canvas canvas(&picture);
        for (std::size_t i = 0; i < walkers_.size(); ++i) {
            const auto figure = figure_of(i, frame);
            paint_shadow(canvas, figure.feet, 0.26 * figure.height);
            paint_figure(canvas, figure);
        }
        return picture;
    }

    Truth truth(int frame) const override {
        Truth truth;
        for (std::size_t i = 0; i < walkers_.size(); ++i) {
            const auto figure = figure_of(i, frame);
            Plane<std::uint8_t> mask(hall_.size());
            Canvas canvas(nullptr, &mask);
            paint_figure(canvas, figure);
            for (auto& behind : truth.objects)
                for (std::size_t p = 0; p < mask.pixels().size(); ++p)
                    if (mask.pixels()[p]) behind.mask.pixels()[p] = 0;
            if (std::find(mask.pixels().begin(), mask.pixels().end(), 255) == mask.pixels().end()) continue;
            const Point middle = middle_of(figure);
            truth.objects.push_back({"walker " + std::to_string(i), middle.x, middle.y,
                                     walkers_[i].speed * scale_ * time_scale_, 0, std::move(mask)});
        }
        return truth;
    }

  private:
    Figure figure_of(std::size_t i, int frame) const {
        const Walker& walker = walkers_[i];
        const double walked = (frame * time_scale_ - walker.enters) * walker.speed;
        const double x = walker.speed > 0 ? walked - walker.height / 2 : width_ + walker.height / 2 + walked;
        const double stride = std::abs(walked) / (0.8 * walker.height) * 2 * std::numbers::pi;
        return {{x * scale_, walker.floor * scale_},
                walker.height * scale_,
                stride,
                walker.speed > 0 ? 1.0 : -1.0,
                1,
                0,
                0,
                seed_ + 10 + i};
    }

    std::span<const Walker> walkers_;
};

Scene make(const Options& options, std::span<const Walker> walkers) {
    const Options all = with_frames(options, walk_frames);
    return {all, std::make_shared<WalkersStory>(all, walkers)};
}

}  // namespace

Scene make_walkers(const Options& options) {
    return make(options, many);
}

Scene make_two_walkers_cross(const Options& options) {
    return make(options, two);
}

}  // namespace vvr::generator
