#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "core/scene/flow_geometry.h"
#include "tests/support/fields.h"
#include "tests/support/layouts.h"
#include "tests/support/planes.h"

namespace vvr {
namespace {

using std::numbers::pi;

using Motion = std::function<glm::dvec2(double column, double row, int frame)>;

/// A volume whose flow is `motion` in every frame, with one seed.
volume::Volume volume_of(Size size, int frames, const Motion& motion, const volume::FrameSeed& seed) {
    volume::Volume volume(size, {.capacity = frames, .keep_flow = true});
    for (int f = 0; f < frames; ++f) {
        fields::Field field = test::field_of(f, size);
        field.flow.u = test::plane_of<float>(size, [&](int i, int j) { return static_cast<float>(motion(i, j, f).x); });
        field.flow.v = test::plane_of<float>(size, [&](int i, int j) { return static_cast<float>(motion(i, j, f).y); });
        if (f == seed.frame) field.seeds = {seed.seed};
        volume.add(field);
    }
    return volume;
}

constexpr Size square{161, 161};
constexpr glm::dvec2 centre{80, 80};

/// A sphere that spins once in 60 frames, seen along its axis.
glm::dvec2 spinning(double column, double row, int) {
    const double omega = 2 * pi / 60;
    return omega * glm::dvec2(-(row - centre.y), column - centre.x);
}

constexpr auto still = [](double, double, int) { return glm::dvec2(0, 0); };
constexpr auto to_the_right = [](double, double, int) { return glm::dvec2(2, 0); };

TEST(Trace, StaysOnItsCircleOverHalfATurn) {
    const volume::Volume volume = volume_of(square, 2, spinning, {});
    const double dt = 0.05;
    for (const double radius : {10.0, 35.0, 70.0}) {
        const auto points = scene::trace(volume, {centre.x + radius, centre.y, 1}, {.dt = dt, .steps = 600});
        ASSERT_EQ(points.size(), 601U);
        for (const glm::dvec3& point : points) {
            EXPECT_NEAR(glm::distance(glm::dvec2(point), centre) / radius, 1, 0.01);
            EXPECT_EQ(point.z, 1) << "without v_t it stays in its frame";
        }
        EXPECT_LT(glm::distance(glm::dvec2(points.back()), centre - glm::dvec2(radius, 0)), 0.01 * radius)
            << "half a turn in half the time";
    }
}

TEST(Trace, ALongerStepStraysFurther) {
    const volume::Volume volume = volume_of(square, 2, spinning, {});
    const auto radius_after = [&](double dt, int steps) {
        return glm::distance(glm::dvec2(scene::trace(volume, {110, 80, 0}, {.dt = dt, .steps = steps}).back()), centre);
    };
    EXPECT_GT(radius_after(1, 30), 1.02 * radius_after(0.05, 600));
}

TEST(Trace, EndsExactlyOnTheBorder) {
    const volume::Volume volume = volume_of({100, 80}, 8, to_the_right, {});
    const auto right = scene::trace(volume, {90.25, 40, 3}, {.steps = 100});
    EXPECT_EQ(right.back(), glm::dvec3(99.5, 40, 3));
    EXPECT_EQ(volume.c_of(right.back()).x, 0);
    EXPECT_EQ(right.size(), 1U + 5) << "four steps of 2 pixels, and what is left of the fifth";

    const auto end = scene::trace(volume, {1, 40, 3}, {.dt = 0.7, .steps = 100, .time_velocity = 1});
    EXPECT_NEAR(end.back().z, 7.5, 1e-12);
    EXPECT_NEAR(end.back().x, 1 + 2 * 4.5, 1e-12) << "cut where it crosses the border, not moved there";
    EXPECT_EQ(volume.c_of(end.back()).z, 1);

    const auto back = scene::trace(volume, {1, 40, 3}, {.steps = 100, .time_velocity = -1});
    EXPECT_EQ(back.back().z, -0.5);
}

TEST(Trace, EndsWhereNothingMoves) {
    EXPECT_EQ(scene::trace(volume_of({20, 20}, 2, still, {}), {3, 4, 0}, {}).size(), 1U);
    const auto stops = [](double, double, int frame) { return glm::dvec2(frame < 4 ? 1 : 0, 0); };
    const auto points = scene::trace(volume_of({20, 20}, 9, stops, {}), {3, 4, 0}, {.steps = 8, .time_velocity = 1});
    EXPECT_EQ(points.back(), glm::dvec3(7, 4, 4)) << "time does not carry it on";
}

TEST(Trace, GoesOnInTimeWhereRestIsNone) {
    const auto resting =
        scene::trace(volume_of({20, 20}, 9, still, {}), {3, 4, 0}, {.steps = 4, .time_velocity = 1, .rest = 0});
    EXPECT_EQ(resting.back(), glm::dvec3(3, 4, 4)) << "a thing at rest has a path along time";
    EXPECT_EQ(scene::trace(volume_of({20, 20}, 2, still, {}), {3, 4, 0}, {.rest = 0}).size(), 1U) << "nothing moves it";
    EXPECT_EQ(scene::trace(volume_of({60, 20}, 2, to_the_right, {}), {3, 4, 0}, {.rest = 3}).size(), 1U)
        << "slower than that";
}

class BentTraceline : public testing::TestWithParam<std::string> {};

TEST_P(BentTraceline, FollowsTheTransformedField) {
    const volume::FrameSeed seed{5, {110, 80, 0, 0}};
    const volume::Volume volume = volume_of(square, 40, spinning, seed);
    const auto layout = space::make_layout(GetParam(), {0.45, 1, 0.55});
    for (const double v_t : {0.0, 0.7}) {
        const double dt = 0.02;
        const scene::TraceOptions options{.dt = dt, .steps = 1000, .time_velocity = v_t, .spacing = 0};
        const auto points = scene::trace(volume, {110, 80, 5}, options);
        ASSERT_GT(points.size(), 900U);
        for (std::size_t i = 0; i + 1 < points.size(); i += 50) {
            // The tangent half way of a step belongs to the field there.
            const glm::dvec3 middle = (points[i] + points[i + 1]) / 2.0;
            const glm::dvec3 tangent =
                (layout->p_from_c(volume.c_of(points[i + 1])) - layout->p_from_c(volume.c_of(points[i]))) / dt;
            const glm::dvec3 v = {volume.flow().at(points[i]), v_t};
            const glm::dvec3 expected = layout->basis(volume.c_of(middle)).transform(volume.c_vector(v));
            EXPECT_LT(glm::distance(tangent, expected), 1e-3 * glm::length(expected)) << i << ", v_t " << v_t;
        }
        const scene::Tracelines lines = scene::tracelines(volume, volume.seeds(), *layout, options);
        ASSERT_EQ(lines.size(), points.size());
        for (std::size_t i = 0; i < points.size(); i += 50) {
            EXPECT_LT(glm::distance(glm::dvec3(lines[i].p), layout->p_from_c(volume.c_of(points[i]))), 1e-6);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Layouts, BentTraceline, testing::ValuesIn(test::layout_names()),
                         [](const auto& tested) { return tested.param; });

TEST(Tracelines, MeasureTheTextureByLength) {
    // It slows down on the way, so steps get shorter.
    const volume::Volume volume =
        volume_of({101, 80}, 4, [](double column, double, int) { return glm::dvec2(0.05 * (100 - column), 0); },
                  {2, {10, 40, 4.5F, 0}});
    const auto layout = space::make_box({0.45, 1, 0.4});
    const scene::Tracelines lines = scene::tracelines(volume, volume.seeds(), *layout, {.steps = 20, .spacing = 0});
    ASSERT_EQ(lines.size(), 21U);
    EXPECT_EQ(lines.front().along, 0);
    EXPECT_EQ(lines.back().along, 1);
    const double whole = glm::distance(lines.front().p, lines.back().p);
    for (const scene::TraceVertex& vertex : lines) {
        EXPECT_NEAR(vertex.length, whole, 1e-6);
        EXPECT_NEAR(vertex.along, glm::distance(vertex.p, lines.front().p) / whole, 1e-5);
    }
    EXPECT_GT(lines[1].along, 0.06) << "more than a twentieth in the first of twenty steps";
    EXPECT_NEAR(lines.front().speed, 4.5, 0.01);
    EXPECT_LT(lines.back().speed, 3);

    const scene::Tracelines sparse = scene::tracelines(volume, volume.seeds(), *layout, {.steps = 20, .spacing = 0.1});
    EXPECT_LT(sparse.size(), 8U);
    EXPECT_EQ(sparse.front().p, lines.front().p);
    EXPECT_EQ(sparse.back().p, lines.back().p) << "the end is where it was";
}

TEST(Tracelines, LeaveOutLinesWithoutLength) {
    const volume::Volume volume = volume_of({20, 20}, 4, still, {2, {10, 10, 0, 0}});
    EXPECT_TRUE(scene::tracelines(volume, volume.seeds(), *space::make_box({}), {}).empty());
}

TEST(Zebra, IsHalfDarkAndHalfBright) {
    const Plane<std::uint8_t> texels = scene::zebra_texels();
    int dark = 0;
    int bright = 0;
    for (const std::uint8_t texel : texels.pixels()) {
        dark += texel < 128 ? 1 : 0;
        bright += texel == 255 ? 1 : 0;
    }
    EXPECT_EQ(dark, texels.width() / 2);
    EXPECT_GT(bright, texels.width() / 4);
}

}  // namespace
}  // namespace vvr
