#include <algorithm>
#include <cmath>

#include "tests/scene/canvas.h"
#include "tests/scene/scene.h"
#include "tests/scene/texture.h"
#include "tests/support/planes.h"

namespace vvr::generator {
namespace {

Bgr grey(double fraction) {
    const auto level = to_byte(fraction);
    return {level, level, level};
}

}  // namespace

Scene make_still(const Options& options) {
    const Options all = with_frames(options, 100);
    const auto paint = [hall = paint_hall(all.size, all.seed, all.detail)](int) { return hall; };
    return told(all, paint, [=](int) { return Truth{{}, Plane<float>(all.size), Plane<float>(all.size)}; });
}

Scene make_shifted_texture(const Options& options) {
    const Options all = with_frames(options, 50);
    const auto paint = [=, texture = Texture(all.seed, 8, 60)](int frame) {
        return test::plane_of<Bgr>(all.size,
                                   [&](int i, int j) { return grey(texture(i - all.u * frame, j - all.v * frame)); });
    };
    const auto plane_of = [=](double value) { return Plane<float>(all.size, static_cast<float>(value)); };
    return told(all, paint, [=](int) { return Truth{{}, plane_of(all.u), plane_of(all.v)}; });
}

Scene make_spinning_sphere(const Options& options) {
    const Options all = with_frames(options, 100);
    const Point middle{(all.size.width - 1) / 2.0, (all.size.height - 1) / 2.0};
    const double radius = 0.4 * std::min(all.size.width, all.size.height);
    const auto paint = [=, texture = Texture(all.seed, 8, 60)](int frame) {
        Plane<Bgr> picture(all.size, grey(0.1));
        const double cosine = std::cos(all.omega * frame);
        const double sine = std::sin(all.omega * frame);
        Canvas(&picture).paint(
            middle, radius + 1, [&](Point p) { return limb(p, middle, middle, radius, radius); },
            [&](Point p) {
                const Point at = p - middle;
                const double light = 0.15 + 0.85 * texture(cosine * at.x + sine * at.y, cosine * at.y - sine * at.x);
                return Colour{light, light, light};
            });
        return picture;
    };
    return told(all, paint, [=](int) {
        Truth truth{{}, Plane<float>(all.size), Plane<float>(all.size)};
        Object disc{"sphere", middle.x, middle.y, 0, 0, Plane<std::uint8_t>(all.size)};
        for (int j = 0; j < all.size.height; ++j) {
            for (int i = 0; i < all.size.width; ++i) {
                const Point at = Point{1.0 * i, 1.0 * j} - middle;
                if (length_of(at.x, at.y) > radius) continue;
                disc.mask.at(i, j) = 255;
                truth.u.at(i, j) = static_cast<float>(-all.omega * at.y);
                truth.v.at(i, j) = static_cast<float>(all.omega * at.x);
            }
        }
        truth.objects.push_back(std::move(disc));
        return truth;
    });
}

Scene make_one_object_a_second(const Options& options) {
    const Options all = with_frames(options, 250);
    const auto place = [=](int frame) {
        const std::uint64_t second = all.seed * 1000 + 2 * static_cast<std::uint64_t>(frame / all.rate);
        return Point{(0.1 + 0.8 * unit(second)) * all.size.width, (0.1 + 0.8 * unit(second + 1)) * all.size.height};
    };
    const auto paint_disc = [=](Canvas canvas, int frame) {
        canvas.paint_disc(place(frame), all.size.height / 14.0, {0.85, 0.85, 0.85});
    };
    const auto paint = [=](int frame) {
        Plane<Bgr> picture(all.size, grey(0.25));
        paint_disc(Canvas(&picture), frame);
        return picture;
    };
    return told(all, paint, [=](int frame) {
        const Point middle = place(frame);
        Truth truth{{{"disc", middle.x, middle.y, 0, 0, Plane<std::uint8_t>(all.size)}}, {}, {}};
        paint_disc(Canvas(nullptr, &truth.objects.front().mask), frame);
        return truth;
    });
}

}  // namespace vvr::generator
