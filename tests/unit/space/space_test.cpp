#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/space/camera.h"
#include "core/space/layout.h"
#include "tests/support/layouts.h"

namespace vvr {
namespace {

class EveryLayout : public testing::TestWithParam<std::string> {
  protected:
    std::unique_ptr<space::Layout> layout = space::make_layout(GetParam(), {0.5, 1.0, 0.4});
    std::mt19937 random{7};

    glm::dvec3 point() {
        std::uniform_real_distribution<double> in(0, 1);
        const double x = in(random);
        const double y = in(random);
        return {x, y, in(random)};
    }
};

TEST_P(EveryLayout, InverseUndoesTheMap) {
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 c = point();
        EXPECT_LT(glm::distance(layout->c_from_p(layout->p_from_c(c)), c), 1e-6);
    }
}

TEST_P(EveryLayout, BasisIsTheDerivativeOfTheMap) {
    constexpr double h = 1e-6;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 c = point();
        const space::Basis basis = layout->basis(c);
        const glm::dvec3 expected[] = {basis.x, basis.y, basis.t};
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step{0};
            step[axis] = h;
            const glm::dvec3 numeric = (layout->p_from_c(c + step) - layout->p_from_c(c - step)) / (2 * h);
            EXPECT_LT(glm::distance(numeric, expected[axis]), 1e-6);
        }
    }
}

TEST_P(EveryLayout, KeepsOneHandedness) {
    const space::Basis basis = layout->basis({0.3, 0.5, 0.37});
    EXPECT_LT(glm::dot(basis.x, glm::cross(basis.y, basis.t)), 0);
}

TEST_P(EveryLayout, DrawsFartherSectionsFirst) {
    const std::vector<double> borders = {0, 0.1, 0.3, 0.45, 0.7, 0.9, 1};
    for (int view = 0; view < 72; ++view) {
        const double angle = view * std::numbers::pi / 36;
        const glm::dvec3 eye = {3.1 * std::sin(angle), 0.8, -3.1 * std::cos(angle) + 0.05};
        const std::vector<int> order = layout->back_to_front(eye, borders);
        ASSERT_EQ(order.size(), borders.size() - 1);
        std::vector<int> place(order.size());
        for (std::size_t i = 0; i < order.size(); ++i) place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
        // Walk along rays through the volume: the sections met first must be drawn last.
        for (int ray = 0; ray < 200; ++ray) {
            const glm::dvec3 towards = layout->p_from_c(point()) - eye;
            int met = -1;
            for (double s = 0; s < 3; s += 0.002) {
                const glm::dvec3 c = layout->c_from_p(eye + s * towards);
                if (c.x < 0 || c.x > 1 || c.z <= 0 || c.z >= 1) continue;
                int section = 0;
                while (borders[static_cast<std::size_t>(section) + 1] < c.z) ++section;
                if (met >= 0 && section != met) {
                    EXPECT_GT(place[static_cast<std::size_t>(met)], place[static_cast<std::size_t>(section)])
                        << "view " << view << ": section " << met << " stands before " << section;
                }
                met = section;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Layouts, EveryLayout, testing::ValuesIn(test::layout_names()),
                         [](const auto& tested) { return tested.param; });

TEST(Horseshoe, HasThePapersCorrectedBasis) {
    const space::Basis basis = space::make_horseshoe({0.5, 1.0, 0.4})->basis({0.3, 0.5, 0.37});
    EXPECT_NEAR(basis.t.x, 1.874, 5e-4);
    EXPECT_NEAR(basis.t.y, 0, 1e-12);
    EXPECT_NEAR(basis.t.z, 0.811, 5e-4);
}

TEST(Horseshoe, RunsFromLeftToRightAwayFromTheViewer) {
    const auto layout = space::make_horseshoe({0.45, 1.0, 0.4});
    EXPECT_LT(layout->p_from_c({0.5, 0, 0}).x, 0);
    EXPECT_GT(layout->p_from_c({0.5, 0, 1}).x, 0);
    EXPECT_GT(layout->p_from_c({0.5, 0, 0.5}).z, 0.5);
}

TEST(FitCamera, HoldsEveryPointAndTouchesTheMargins) {
    const auto layout = space::make_horseshoe({0.45, 1.0, 0.4});
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= 40; ++i) {
        for (int corner = 0; corner < 4; ++corner)
            points.push_back(layout->p_from_c({corner & 1, corner >> 1, i / 40.0}));
    }
    for (const double fov : {0.0, 20.0, 60.0}) {
        for (const Size size : {Size{1280, 800}, Size{300, 900}, Size{640, 640}}) {
            for (const double elevation : {-30.0, 0.0, 38.0, 90.0}) {
                for (const double azimuth : {-120.0, 0.0, 45.0}) {
                    const space::Camera camera = space::fit_camera({azimuth, elevation, fov, 0.05}, points, size);
                    double nearest_edge = 1;
                    for (const glm::dvec3& p : points) {
                        const glm::dvec2 at = camera.pixel(p, size) / glm::dvec2(size.width, size.height);
                        nearest_edge = std::min({nearest_edge, at.x, at.y, 1 - at.x, 1 - at.y});
                        const glm::dvec4 clip = camera.clip_from_p() * glm::dvec4(p, 1);
                        EXPECT_LE(std::abs(clip.z), clip.w);
                    }
                    EXPECT_NEAR(nearest_edge, 0.05, 1e-6) << fov << " " << elevation << " " << azimuth;
                }
            }
        }
    }
}

TEST(FitCamera, ShowsTheFirstFrameUnmirroredOnTheLeft) {
    const auto layout = space::make_horseshoe({0.45, 1.0, 0.4});
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 8; ++i) points.push_back(layout->p_from_c({i & 1, i >> 1 & 1, i >> 2}));
    points.push_back(layout->p_from_c({1, 0, 0.5}));
    const Size size{1280, 800};
    const space::Camera camera = space::fit_camera({}, points, size);
    const glm::dvec2 left_column = camera.pixel(layout->p_from_c({1, 0.5, 0}), size);  // x_C = 1 is column 0
    const glm::dvec2 right_column = camera.pixel(layout->p_from_c({0, 0.5, 0}), size);
    const glm::dvec2 top_row = camera.pixel(layout->p_from_c({0.5, 1, 0}), size);
    const glm::dvec2 bottom_row = camera.pixel(layout->p_from_c({0.5, 0, 0}), size);
    EXPECT_LT(left_column.x, right_column.x);
    EXPECT_LT(right_column.x, size.width / 2);
    EXPECT_LT(top_row.y, bottom_row.y);
}

}  // namespace
}  // namespace vvr
