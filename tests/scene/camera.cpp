#include "tests/scene/camera.h"

#include <algorithm>
#include <array>
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

/// Weights of four neighbouring pixels, at -1, 0, 1 and 2, for a place between 0 and 1: the cubic B-spline. It blurs
/// all places alike, as optics do; if one between two pixels were blurred more, a shake would change the picture's
/// sharpness.
std::array<double, 4> weights_at(double t) {
    const double u = 1 - t;
    return {u * u * u / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * u * u * u - 6 * u * u + 4) / 6, t * t * t / 6};
}

/// The picture that a camera sees if it looks elsewhere; beyond its edges the picture goes on as there.
Plane<Bgr> seen_from(const Plane<Bgr>& picture, const Point& shift) {
    using Level = std::array<double, 3>;
    const Size size = picture.size();
    const int left = static_cast<int>(std::floor(-shift.x));
    const int above = static_cast<int>(std::floor(-shift.y));
    const std::array<double, 4> across = weights_at(-shift.x - left);
    const std::array<double, 4> down = weights_at(-shift.y - above);
    const auto sum = [](const std::array<double, 4>& weights, auto pixel) {
        Level result{};
        for (std::size_t k = 0; k < 4; ++k) {
            for (std::size_t c = 0; c < 3; ++c) result[c] += weights[k] * pixel(static_cast<int>(k) - 1)[c];
        }
        return result;
    };
    const auto rows = test::plane_of<Level>(size, [&](int i, int j) {
        return sum(across, [&](int k) { return picture.at(std::clamp(i + left + k, 0, size.width - 1), j); });
    });
    return test::plane_of<Bgr>(size, [&](int i, int j) {
        const Level level = sum(down, [&](int k) { return rows.at(i, std::clamp(j + above + k, 0, size.height - 1)); });
        return Bgr{to_level(level[0]), to_level(level[1]), to_level(level[2])};
    });
}

}  // namespace

Scene make_shaken(const Scene& still) {
    const auto paint = [=](int frame) { return seen_from(still.frame(frame), shake_at(frame, still.frames())); };
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
