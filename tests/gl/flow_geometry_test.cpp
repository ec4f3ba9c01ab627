#include "core/scene/flow_geometry.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "gl/renderer.h"
#include "tests/support/fields.h"
#include "tests/support/ray_caster.h"
#include "tests/support/volumes.h"

namespace vvr {
namespace {

using test::draw_volume;
using test::Drawn;
using test::Shot;

/// Black geometry on white: one minus a pixel is how much of it is covered.
Shot black_on_white(Size size) {
    Shot shot;
    shot.options.size = size;
    shot.options.glyphs.slow_colour = shot.options.glyphs.fast_colour = {0, 0, 0};
    shot.transfer = scene::TransferFunction({{0, {}, 0}});
    return shot;
}

struct Place {
    std::string layout;
    fields::Seed seed;
    std::int64_t frame;
};

class ArrowTip : public testing::TestWithParam<Place> {};

TEST_P(ArrowTip, LiesWhereTheMapPutsIt) {
    const auto& [layout_name, seed, frame] = GetParam();
    constexpr Size field_size{96, 72};
    volume::Volume volume(field_size, {64});
    for (int i = 0; i < 64; ++i) {
        fields::Field field = test::field_of(i, field_size);
        if (i == frame) field.seeds = {seed};
        volume.add(field);
    }
    Shot shot = black_on_white({1280, 960});
    shot.layout = layout_name;
    shot.options.glyphs.thickness = 1;  // as blunt as it gets
    const auto layout = space::make_layout(layout_name, space::shape_for(field_size));
    shot.scene.arrows = scene::arrows(volume, volume.seeds(), *layout, {.frames = 16, .cap = 1});
    const Drawn drawn = draw_volume(volume, shot);

    // Where the particle is after so many frames, by the map alone: the frame's plane is not bent.
    const auto pixel_of = [&, &seed = seed, &frame = frame](double frames) {
        const glm::dvec3 c = {1 - (seed.x + frames * seed.u + 0.5) / field_size.width,
                              1 - (seed.y + frames * seed.v + 0.5) / field_size.height,
                              (static_cast<double>(frame) + 0.5) / 64};
        return drawn.camera.pixel(layout->p_from_c(c), shot.options.size);
    };
    const glm::dvec2 tip = pixel_of(16);
    const glm::dvec2 along = glm::normalize(tip - pixel_of(0));
    ASSERT_GT(glm::distance(tip, pixel_of(0)), 50);

    // The cone's width grows evenly from the tip on; the pixels of its first part say where it begins.
    std::map<int, double> widths;
    double beside = 0;
    double covered = 0;
    for (int j = 0; j < shot.options.size.height; ++j) {
        for (int i = 0; i < shot.options.size.width; ++i) {
            const double part = 1 - static_cast<double>(drawn.picture.at(i, j).x);
            const glm::dvec2 away = glm::dvec2(i + 0.5, j + 0.5) - tip;
            const double behind = -glm::dot(away, along);
            if (behind < -1.5) {
                ASSERT_EQ(part, 0) << "nothing beyond the tip";
            }
            // Each pixel is shared by the two marks beside it, as pixels stand askew to the arrow.
            const int low = static_cast<int>(std::floor(behind));
            widths[low] += part * (low + 1 - behind);
            widths[low + 1] += part * (behind - low);
            if (behind < 2 || behind > 14) continue;
            beside += part * (away.x * along.y - away.y * along.x);
            covered += part;
        }
    }
    std::erase_if(widths, [](const auto& width) { return width.first < 3 || width.first > 14; });
    ASSERT_EQ(widths.size(), 12U);
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [behind, width] : widths) {
        n += 1;
        x += behind;
        y += width;
        xx += static_cast<double>(behind) * behind;
        xy += behind * width;
    }
    const double slope = (n * xy - x * y) / (n * xx - x * x);
    const double begin = (x - y / slope) / n;
    EXPECT_LT(std::abs(begin), 0.5) << "along the arrow";
    EXPECT_LT(std::abs(beside / covered), 0.5) << "across it";
}

INSTANTIATE_TEST_SUITE_P(Places, ArrowTip,
                         testing::Values(Place{"horseshoe", {30, 30, 2.5F, 0.5F}, 8},
                                         Place{"horseshoe", {50, 20, -1, 2.5F}, 20},
                                         Place{"horseshoe", {70, 40, -2.5F, 0}, 57}, Place{"box", {30, 60, 1, -3}, 30}),
                         [](const auto& tested) {
                             return tested.param.layout + "_" + std::to_string(tested.param.frame);
                         });

/// A straight traceline.
scene::Tracelines line(const glm::vec3& from, const glm::vec3& to) {
    const float length = glm::distance(from, to);
    return {{from, 0, length, 1}, {(from + to) / 2.0F, 0.5F, length, 1}, {to, 1, length, 1}};
}

const scene::TransferFunction nothing({{0, {}, 0}});

/// The box seen along its depth, from the front.
Shot before_the_box(const scene::TransferFunction& transfer = scene::TransferFunction({{0, {0, 0, 1}, 4}})) {
    Shot shot;
    shot.options.size = {160, 120};
    shot.options.samples = 1;
    shot.options.slices = 600;
    shot.layout = "box";
    shot.options.view = {0, 0, 0, 0.04};
    shot.transfer = transfer;
    shot.options.glyphs.slow_colour = shot.options.glyphs.fast_colour = {1, 0, 0};
    shot.options.traces.shade = 1;
    shot.options.traces.width = 0.2F;
    return shot;
}

TEST(Tracelines, HideTheVolumeAndAreHidden) {
    const volume::Volume volume = test::full_volume({32, 24}, 40);
    const auto middle_with_line_at = [&](float z) {
        Shot shot = before_the_box();
        shot.scene.tracelines = line({-0.25F, 0.2F, z}, {0.25F, 0.2F, z});
        return draw_volume(volume, shot).picture.at(80, 60);
    };
    const glm::vec4 before = middle_with_line_at(-0.03F);
    const glm::vec4 inside = middle_with_line_at(0.275F);
    const glm::vec4 behind = middle_with_line_at(0.6F);
    EXPECT_EQ(before.z, 0) << "nothing of the volume before it";
    EXPECT_GT(before.x, 0.5);
    EXPECT_NEAR(inside.z, 1 - std::exp(-4 * 0.275), 0.02);
    EXPECT_NEAR(behind.z, 1 - std::exp(-4 * 0.55), 0.02);
    EXPECT_GT(inside.x, behind.x);
    EXPECT_GT(behind.x, 0.03) << "it shines through a little";
}

TEST(Tracelines, HideEachOtherAndArrows) {
    const volume::Volume volume = test::full_volume({32, 24}, 40);
    const auto middle = [&](float line_z, float arrow_z) {
        Shot shot = before_the_box(nothing);
        shot.options.glyphs.thickness = 1;
        shot.options.glyphs.speed_range = {1, 2};
        shot.options.glyphs.fast_colour = {0, 1, 0};
        shot.scene.tracelines = line({-0.25F, 0.2F, line_z}, {0.25F, 0.2F, line_z});  // slow
        shot.scene.arrows = {{{0, -0.2F, arrow_z}, {0, 0.8F, 0}, 2}};                 // fast, upwards across it
        return draw_volume(volume, shot).picture.at(80, 60);
    };
    const glm::vec4 line_before = middle(0.0F, 0.3F);
    EXPECT_GT(line_before.x, 0.5);
    EXPECT_EQ(line_before.y, 0);
    const glm::vec4 arrow_before = middle(0.3F, 0.0F);
    EXPECT_GT(arrow_before.y, 0.5);
    EXPECT_EQ(arrow_before.x, 0);
}

TEST(Tracelines, AreOfTheirWidthAndNeverThinnerThanAsked) {
    const volume::Volume volume = test::full_volume({32, 24}, 40);
    for (const float width : {0.2F, 0.001F}) {
        Shot shot = before_the_box(nothing);
        shot.options.samples = 4;
        shot.options.glyphs.slow_colour = shot.options.glyphs.fast_colour = {0, 0, 0};
        shot.options.traces.width = width;
        shot.options.traces.min_width = 1.5F;
        shot.scene.tracelines = line({-0.5F, 0.2F, 0.1F}, {0.5F, 0.2F, 0.1F});
        const Drawn drawn = draw_volume(volume, shot);
        const double unit =
            drawn.camera.pixel({1, 0, 0}, shot.options.size).x - drawn.camera.pixel({0, 0, 0}, shot.options.size).x;
        double covered = 0;
        int columns = 0;
        for (int i = 60; i < 100; ++i, ++columns) {
            for (int j = 0; j < 120; ++j) covered += 1 - static_cast<double>(drawn.picture.at(i, j).x);
        }
        EXPECT_NEAR(covered / columns, std::max(width * unit, 1.5), 0.3) << width;
    }
}

TEST(Tracelines, LineUpWithoutJoiningOneAnother) {
    const volume::Volume volume = test::full_volume({32, 24}, 40);
    Shot shot = before_the_box(nothing);
    shot.options.traces.width = 0.02F;
    shot.scene.tracelines = line({-0.5F, 0.1F, 0.1F}, {-0.4F, 0.1F, 0.1F});
    const scene::Tracelines other = line({0.4F, 0.3F, 0.1F}, {0.5F, 0.3F, 0.1F});
    shot.scene.tracelines.insert(shot.scene.tracelines.end(), other.begin(), other.end());
    const Drawn drawn = draw_volume(volume, shot);
    EXPECT_EQ(drawn.at({-0.45, 0.1, 0.1}).y, 0);
    EXPECT_EQ(drawn.at({0.45, 0.3, 0.1}).y, 0);
    EXPECT_EQ(drawn.at({0, 0.2, 0.1}), glm::vec4(1)) << "between the end of one and the beginning of the next";
}

/// A scene with tracelines, drawn several times by one renderer.
class Animated {
  public:
    Animated() : volume_(test::wandering_balls({48, 36}, 32)) {
        options_.size = {320, 240};
        renderer_.emplace(*context_, *layout_, options_);
        renderer_->set_transfer(scene::default_transfer_function());
        window_.emplace(context_->gl(), *layout_, 32, 1);
        window_->show(volume_, volume::cut_into(32, 1));
        renderer_->set_scene({{}, line({-0.7F, 0.3F, 0.1F}, {0.6F, 0.35F, 0.3F}), {}, {}, {}});
    }

    Plane<glm::vec4> draw(double phase) { return renderer_->draw(*window_, phase); }
    const space::Camera& camera() const { return renderer_->camera(); }
    Size size() const { return options_.size; }

  private:
    volume::Volume volume_;
    std::unique_ptr<space::Layout> layout_ = space::make_layout("horseshoe", space::shape_for({48, 36}));
    std::unique_ptr<gl::Context> context_ = gl::open_context("software");
    gl::RenderOptions options_;
    std::optional<gl::Renderer> renderer_;
    std::optional<gl::BrickWindow> window_;
};

TEST(Zebra, MovesWithThePhaseAndComesRound) {
    Animated animated;
    const Plane<glm::vec4> first = animated.draw(0);
    for (const double phase : {0.25, 0.5, 0.75}) {
        EXPECT_GT(test::max_difference(animated.draw(phase), first), 50) << phase;
    }
    EXPECT_LE(test::max_difference(animated.draw(1), first), 1) << "after the last comes the first";
    EXPECT_EQ(test::max_difference(animated.draw(0), first), 0);
}

TEST(Zebra, ChangesNothingButTheLines) {
    Animated animated;
    const Plane<glm::vec4> first = animated.draw(0);
    const Plane<glm::vec4> later = animated.draw(0.5);
    const glm::dvec2 from = animated.camera().pixel({-0.7, 0.3, 0.1}, animated.size());
    const glm::dvec2 to = animated.camera().pixel({0.6, 0.35, 0.3}, animated.size());
    const glm::dvec2 along = glm::normalize(to - from);
    for (int j = 0; j < first.height(); ++j) {
        for (int i = 0; i < first.width(); ++i) {
            const glm::dvec2 away = glm::dvec2(i + 0.5, j + 0.5) - from;
            if (std::abs(away.x * along.y - away.y * along.x) < 4) continue;
            ASSERT_EQ(first.at(i, j), later.at(i, j)) << i << " " << j;
        }
    }
}

TEST(Zebra, MovesInTheDirectionOfTheFlow) {
    // One long line from left to right, wide stripes: where the brightness of the line correlates best after a small
    // step of the phase is a little further on.
    Shot shot = before_the_box();
    shot.options.traces.shade = 0;
    shot.options.traces.width = 0.06F;
    shot.options.traces.stripe_length = 0.4F;
    const auto layout = space::make_layout("box", space::shape_for({32, 24}));
    const auto context = gl::open_context("software");
    gl::BrickWindow empty(context->gl(), *layout, 40, 1);
    gl::Renderer renderer(*context, *layout, shot.options);
    renderer.set_scene({{}, line({-1, 0.2F, 0.1F}, {1, 0.2F, 0.1F}), {}, {}, {}});
    const Plane<glm::vec4> first = renderer.draw(empty, 0);
    const Plane<glm::vec4> later = renderer.draw(empty, 0.25);
    const double stripe = 0.4 * (renderer.camera().pixel({1, 0, 0}, shot.options.size).x -
                                 renderer.camera().pixel({0, 0, 0}, shot.options.size).x);
    const auto alike = [&](double shift) {
        double sum = 0;
        for (int i = 40; i < 120; ++i) {
            sum += static_cast<double>(
                std::abs(later.at(i, 60).x - first.at(i - static_cast<int>(std::lround(shift)), 60).x));
        }
        return -sum;
    };
    EXPECT_GT(alike(stripe / 4), alike(0));
    EXPECT_GT(alike(stripe / 4), alike(-stripe / 4));
    EXPECT_GT(alike(stripe / 4), -0.15 * 80);
}

}  // namespace
}  // namespace vvr
