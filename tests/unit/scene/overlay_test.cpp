#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "core/scene/scene.h"
#include "core/scene/slices.h"
#include "tests/support/fields.h"

namespace vvr {
namespace {

constexpr glm::vec4 green{0, 1, 0, 1};

volume::Volume dot_at(int column, int row, int frame) {
    volume::Volume volume({64, 48}, {64});
    for (int i = 0; i < 64; ++i) {
        fields::Field field = test::field_of(i, {64, 48});
        if (i == frame) field.scalar.at(column, row) = 255;
        volume.add(field);
    }
    return volume;
}

TEST(Boxes, HoldTheLayoutAndWhatIsSeen) {
    const auto layout = space::make_horseshoe({0.45, 1, 0.4});
    const scene::BoundingBox all = scene::layout_bounds(*layout);
    EXPECT_LT(glm::distance(all.low, glm::dvec3(-1, 0, 0)), 1e-9);
    EXPECT_LT(glm::distance(all.high, glm::dvec3(1, 0.4, 1)), 1e-9);

    const volume::BrickCells cells = volume::brick_cells(volume::BrickLayers(dot_at(10, 40, 32), {0, 64}), 1, *layout);
    const std::vector<volume::PlacedCells> bricks = {{&cells}};
    const scene::BoundingBox seen = scene::visible_bounds(bricks, *layout, scene::default_transfer_function());
    const glm::dvec3 dot = layout->p_from_c({1 - 10.5 / 64, 1 - 40.5 / 48, 32.5 / 64});
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LT(seen.low[axis], dot[axis]);
        EXPECT_GT(seen.high[axis], dot[axis]);
        EXPECT_LT(seen.high[axis] - seen.low[axis], 0.35) << "a few cells, not the whole";
    }
    EXPECT_TRUE(scene::visible_bounds(bricks, *layout, scene::default_transfer_function().scaled(0)).empty());
    EXPECT_TRUE(scene::box_edges({}, green).empty());
}

TEST(Boxes, HaveTwelveEdges) {
    const auto edges = scene::box_edges({{0, 0, 0}, {1, 2, 4}}, green);
    ASSERT_EQ(edges.size(), 12U);
    double length = 0;
    for (const scene::LineSegment& edge : edges) length += static_cast<double>(glm::distance(edge.from, edge.to));
    EXPECT_DOUBLE_EQ(length, 4 * (1 + 2 + 4));
}

TEST(SliceOutlines, AreClosedPolygonsAcrossTheView) {
    const scene::BoundingBox box{{-1, 0, 0}, {1, 0.4, 1}};
    const auto layout = space::make_horseshoe({0.45, 1, 0.4});
    for (const double azimuth : {0.0, 25.0}) {
        const space::Camera camera = space::fit_camera({azimuth, 30, 30}, scene::outline_points(*layout), {640, 480});
        const scene::SliceStack stack = scene::stack_slices(camera, *layout, 300, 0);
        const auto lines = scene::slice_outlines(box, camera, stack, 20, green);
        std::set<int> depths;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const auto slice = [&](const glm::vec3& p) {
                return (glm::dot(glm::dvec3(p) - camera.eye, camera.forward) - stack.nearest) / stack.spacing;
            };
            EXPECT_NEAR(slice(lines[i].from), slice(lines[i].to), 1e-3) << "a side lies in its slice";
            EXPECT_NEAR(slice(lines[i].from), std::round(slice(lines[i].from)), 1e-3);
            depths.insert(static_cast<int>(std::lround(slice(lines[i].from))));
            // The next side begins where this one ends, or this was the last of its slice.
            const bool goes_on = i + 1 < lines.size() && lines[i + 1].from == lines[i].to;
            const bool closes =
                std::ranges::any_of(lines, [&](const scene::LineSegment& s) { return s.from == lines[i].to; });
            EXPECT_TRUE(goes_on || closes);
        }
        EXPECT_GE(depths.size(), 19U);
        EXPECT_LE(depths.size(), 24U);
    }
    EXPECT_TRUE(scene::slice_outlines({}, space::Camera{}, {}, 20, green).empty());
}

}  // namespace
}  // namespace vvr
