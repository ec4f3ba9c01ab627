#include "tests/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "tests/scene/canvas.h"
#include "tests/support/planes.h"

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
        result[c] = to_level(above * (1 - t) + below * t);
    }
    return result;
}

}  // namespace

Scene make_shaken(const Scene& still) {
    const auto paint = [=](int frame) {
        const Plane<Bgr> picture = still.frame(frame);
        const Point shift = shake_at(frame, still.frames());
        return test::plane_of<Bgr>(picture.size(),
                                   [&](int i, int j) { return level_at(picture, i - shift.x, j - shift.y); });
    };
    return told({.size = still.size(), .frames = still.frames(), .rate = still.rate()}, paint,
                [=](int frame) { return still.truth(frame); });
}

Scene make_thinned(const Scene& whole, int every, int first) {
    const int frames = (whole.frames() - first + every - 1) / every;
    const auto truth = [=](int frame) {
        Truth slower = whole.truth(first + frame * every);
        for (Object& object : slower.objects) {
            object.vx *= every;
            object.vy *= every;
        }
        return slower;
    };
    return told(
        {.size = whole.size(), .frames = frames, .rate = whole.rate() / every},
        [=](int frame) { return whole.frame(first + frame * every); }, truth);
}

}  // namespace vvr::generator
