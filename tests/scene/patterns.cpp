#include <algorithm>
#include <cmath>

#include "tests/scene/canvas.h"
#include "tests/scene/scene.h"
#include "tests/scene/texture.h"

namespace vvr::generator {
namespace {

Bgr grey(double fraction) {
    const auto level = to_byte(fraction);
    return {level, level, level};
}

Options with_frames(Options options, int frames) {
    if (options.frames <= 0) options.frames = frames;
    return options;
}

class Still final : public Story {
  public:
    explicit Still(const Options& options) : hall_(paint_hall(options.size, options.seed, options.detail)) {}

    Plane<Bgr> paint(int) const override { return hall_; }
    Truth truth(int) const override { return {{}, Plane<float>(hall_.size()), Plane<float>(hall_.size())}; }

  private:
    Plane<Bgr> hall_;
};

class ShiftedTexture final : public Story {
  public:
    explicit ShiftedTexture(const Options& options) : options_(options), texture_(options.seed, 8, 60) {}

    Plane<Bgr> paint(int frame) const override {
        Plane<Bgr> picture(options_.size);
        for (int j = 0; j < picture.height(); ++j)
            for (int i = 0; i < picture.width(); ++i)
                picture.at(i, j) = grey(texture_(i - options_.u * frame, j - options_.v * frame));
        return picture;
    }

    Truth truth(int) const override {
        return {{},
                Plane<float>(options_.size, static_cast<float>(options_.u)),
                Plane<float>(options_.size, static_cast<float>(options_.v))};
    }

  private:
    Options options_;
    Texture texture_;
};

class SpinningSphere final : public Story {
  public:
    explicit SpinningSphere(const Options& options)
        : options_(options),
          middle_{(options.size.width - 1) / 2.0, (options.size.height - 1) / 2.0},
          radius_(0.4 * std::min(options.size.width, options.size.height)),
          texture_(options.seed, 8, 60) {}

    Plane<Bgr> paint(int frame) const override {
        Plane<Bgr> picture(options_.size, grey(0.1));
        const double cosine = std::cos(options_.omega * frame);
        const double sine = std::sin(options_.omega * frame);
        Canvas canvas(&picture);
        canvas.paint(
            middle_, radius_ + 1, [&](Point p) { return std::hypot(p.x - middle_.x, p.y - middle_.y) - radius_; },
            [&](Point p) {
                const double x = p.x - middle_.x;
                const double y = p.y - middle_.y;
                const double light = 0.15 + 0.85 * texture_(cosine * x + sine * y, cosine * y - sine * x);
                return Colour{light, light, light};
            });
        return picture;
    }

    Truth truth(int) const override {
        Truth truth{{}, Plane<float>(options_.size), Plane<float>(options_.size)};
        Object disc{"sphere", middle_.x, middle_.y, 0, 0, Plane<std::uint8_t>(options_.size)};
        for (int j = 0; j < options_.size.height; ++j)
            for (int i = 0; i < options_.size.width; ++i) {
                const double x = i - middle_.x;
                const double y = j - middle_.y;
                if (std::hypot(x, y) > radius_) continue;
                disc.mask.at(i, j) = 255;
                truth.u.at(i, j) = static_cast<float>(-options_.omega * y);
                truth.v.at(i, j) = static_cast<float>(options_.omega * x);
            }
        truth.objects.push_back(std::move(disc));
        return truth;
    }

  private:
    Options options_;
    Point middle_;
    double radius_;
    Texture texture_;
};

class OneObjectASecond final : public Story {
  public:
    explicit OneObjectASecond(const Options& options) : options_(options) {}

    Plane<Bgr> paint(int frame) const override {
        Plane<Bgr> picture(options_.size, grey(0.25));
        Canvas canvas(&picture);
        paint_disc(canvas, frame);
        return picture;
    }

    Truth truth(int frame) const override {
        const Point middle = place(frame);
        Object disc{"disc", middle.x, middle.y, 0, 0, Plane<std::uint8_t>(options_.size)};
        Canvas canvas(nullptr, &disc.mask);
        paint_disc(canvas, frame);
        Truth truth;
        truth.objects.push_back(std::move(disc));
        return truth;
    }

  private:
    double radius() const { return options_.size.height / 14.0; }

    Point place(int frame) const {
        const auto second = static_cast<std::uint64_t>(frame / options_.rate);
        const double x = unit(options_.seed * 1000 + 2 * second);
        const double y = unit(options_.seed * 1000 + 2 * second + 1);
        return {(0.1 + 0.8 * x) * options_.size.width, (0.1 + 0.8 * y) * options_.size.height};
    }

    void paint_disc(Canvas& canvas, int frame) const {
        const Point middle = place(frame);
        canvas.paint(
            middle, radius() + 1, [&](Point p) { return std::hypot(p.x - middle.x, p.y - middle.y) - radius(); },
            [](Point) {
                return Colour{0.85, 0.85, 0.85};
            });
    }

    Options options_;
};

}  // namespace

Scene make_still(const Options& options) {
    const auto all = with_frames(options, 100);
    return {all, std::make_shared<Still>(all)};
}

Scene make_shifted_texture(const Options& options) {
    const auto all = with_frames(options, 50);
    return {all, std::make_shared<ShiftedTexture>(all)};
}

Scene make_spinning_sphere(const Options& options) {
    const auto all = with_frames(options, 100);
    return {all, std::make_shared<SpinningSphere>(all)};
}

Scene make_one_object_a_second(const Options& options) {
    const auto all = with_frames(options, 250);
    return {all, std::make_shared<OneObjectASecond>(all)};
}

}  // namespace vvr::generator
