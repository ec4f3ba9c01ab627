#include "tests/scene/shaken.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "tests/scene/canvas.h"

namespace vvr::generator {
namespace {

/// Where the camera looks at a frame: up to six pixels to each side, and still for the clip's first tenth.
Point shake_at(int frame, int frames) {
    if (10 * frame < frames) return {0, 0};
    return {6 * std::sin(1.7 * frame) * std::cos(0.31 * frame), 6 * std::cos(2.3 * frame + 1)};
}

/// A picture between its pixels; beyond its edges it goes on as there.
Bgr level_at(const Plane<Bgr>& picture, double x, double y) {
    const int i = static_cast<int>(std::floor(x));
    const int j = static_cast<int>(std::floor(y));
    const double s = x - i, t = y - j;
    const auto pixel = [&](int u, int v) {
        return picture.at(std::clamp(u, 0, picture.width() - 1), std::clamp(v, 0, picture.height() - 1));
    };
    Bgr result;
    for (std::size_t c = 0; c < 3; ++c) {
        const double above = pixel(i, j)[c] * (1 - s) + pixel(i + 1, j)[c] * s;
        const double below = pixel(i, j + 1)[c] * (1 - s) + pixel(i + 1, j + 1)[c] * s;
        result[c] = static_cast<std::uint8_t>(std::lround(above * (1 - t) + below * t));
    }
    return result;
}

/// A scene seen by a camera that shakes.
class Shaken final : public Story {
  public:
    explicit Shaken(Scene still) : still_(std::move(still)) {}

    Plane<Bgr> paint(int frame) const override {
        const Plane<Bgr> picture = still_.frame(frame);
        const Point shift = shake_at(frame, still_.frames());
        Plane<Bgr> moved(picture.size());
        for (int j = 0; j < moved.height(); ++j) {
            for (int i = 0; i < moved.width(); ++i) moved.at(i, j) = level_at(picture, i - shift.x, j - shift.y);
        }
        return moved;
    }

    Truth truth(int frame) const override { return still_.truth(frame); }

  private:
    Scene still_;
};

}  // namespace

Scene make_shaken(const Scene& still) {
    Options options;
    options.size = still.size();
    options.frames = still.frames();
    options.rate = still.rate();
    return {options, std::make_shared<Shaken>(still)};
}

}  // namespace vvr::generator
