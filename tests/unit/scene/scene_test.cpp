#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/scene/flow_geometry.h"
#include "core/scene/slices.h"
#include "core/scene/transfer_function.h"
#include "tests/support/fields.h"

namespace vvr {
namespace {

TEST(TransferFunction, InterpolatesBetweenItsPoints) {
    const scene::TransferFunction transfer({{10, {0, 0, 0}, 0}, {20, {1, 0.5, 0}, 8}});
    EXPECT_DOUBLE_EQ(transfer.at(0).w, 0);
    EXPECT_DOUBLE_EQ(transfer.at(15).w, 4);
    EXPECT_DOUBLE_EQ(transfer.at(15).y, 0.25);
    EXPECT_DOUBLE_EQ(transfer.at(200).w, 8);
    EXPECT_DOUBLE_EQ(transfer.scaled(0.5).at(20).w, 4);
}

TEST(TransferFunction, KnowsWhichRangesAreVisible) {
    const scene::TransferFunction transfer({{0, {}, 0}, {10, {}, 0}, {20, {}, 8}, {30, {}, 0}, {255, {}, 0}});
    EXPECT_FALSE(transfer.visible({0, 10}));
    EXPECT_TRUE(transfer.visible({0, 11}));
    EXPECT_TRUE(transfer.visible({0, 255})) << "interpolation passes through the visible values";
    EXPECT_FALSE(transfer.visible({30, 255}));
    EXPECT_FALSE(transfer.visible(volume::ValueRange{})) << "no value at all";
}

TEST(TransferFunction, RefusesNonsense) {
    EXPECT_THROW(scene::TransferFunction({}), Error);
    EXPECT_THROW(scene::TransferFunction({{10, {}, 0}, {5, {}, 0}}), Error);
    EXPECT_THROW(scene::TransferFunction({{10, {}, -1}}), Error);
    EXPECT_THROW(scene::TransferFunction({{10, {}, std::numeric_limits<double>::quiet_NaN()}}), Error);
}

/// Area of all pieces of one brick's slices.
double area_of(const scene::SliceMesh& mesh) {
    double area = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.vertices[mesh.indices[i]].p;
        const glm::dvec3 b = mesh.vertices[mesh.indices[i + 1]].p;
        const glm::dvec3 c = mesh.vertices[mesh.indices[i + 2]].p;
        area += glm::length(glm::cross(b - a, c - a)) / 2;
    }
    return area;
}

/// A whole volume as one brick, in slices.
struct Sliced {
    space::Camera camera;
    scene::SliceStack stack;
    scene::SliceMesh mesh;

    Sliced(const volume::Volume& volume, const space::Layout& layout, const space::View& view, int slices)
        : camera(space::fit_camera(view, scene::outline_points(layout), {640, 480})),
          stack(scene::stack_slices(camera, layout, slices, 0)) {
        const volume::BrickCells cells =
            volume::brick_cells(volume::BrickLayers(volume, {0, volume.layers()}), 1, layout);
        mesh = scene::cut_slices(std::vector<volume::PlacedCells>{{&cells}}, 0, layout,
                                 scene::default_transfer_function(), camera, stack);
    }
};

TEST(Slices, FillTheVolumeExactlyOnce) {
    for (const std::string name : {"box", "horseshoe"}) {
        const volume::Volume volume = test::even_volume({48, 40}, 64, 255);
        const auto layout = space::make_layout(name, {0.45, 1, 0.4});
        const double depth = 0.55;
        const double length = std::numbers::pi * (0.45 + 1) / 2;
        for (const double azimuth : {0.0, 33.0, 90.0, 180.0}) {
            for (const double elevation : {0.0, 38.0, 90.0}) {
                const Sliced sliced(volume, *layout, {azimuth, elevation, 30}, 300);
                EXPECT_NEAR(area_of(sliced.mesh) * sliced.stack.spacing / (depth * 0.4 * length), 1, 0.01)
                    << name << " " << azimuth << " " << elevation;
            }
        }
    }
}

TEST(Slices, GoFromFarToNear) {
    const auto layout = space::make_horseshoe({0.45, 1, 0.4});
    const auto [camera, stack, mesh] = Sliced(test::even_volume({32, 32}, 32, 255), *layout, {}, 50);
    ASSERT_FALSE(mesh.indices.empty());
    double before = std::numeric_limits<double>::infinity();
    for (const std::uint32_t index : mesh.indices) {
        const double away = glm::dot(glm::dvec3(mesh.vertices[index].p) - camera.eye, camera.forward);
        EXPECT_LE(away, before + 1e-5);
        before = away;
    }
}

TEST(Slices, PassOverWhatCannotBeSeen) {
    const auto layout = space::make_horseshoe({0.45, 1, 0.4});
    EXPECT_TRUE(Sliced(test::even_volume({64, 64}, 64), *layout, {}, 50).mesh.indices.empty());
}

/// With a seed in its first frame.
volume::Volume volume_with_a_seed() {
    volume::Volume volume({100, 80}, {64});
    for (int i = 0; i < 64; ++i) {
        fields::Field field = test::field_of(i, {100, 80});
        if (i == 0) field.seeds = {{20, 30, 1.5F, -0.5F}};
        volume.add(field);
    }
    return volume;
}

TEST(Arrows, StartAtTheirSeedAndFollowTheTransformedFlow) {
    const volume::Volume volume = volume_with_a_seed();
    const auto layout = space::make_horseshoe({0.45, 1, 0.4});
    const std::vector<scene::Glyph> glyphs = scene::arrows(volume, volume.seeds(), *layout, {.frames = 1, .cap = 1});
    ASSERT_EQ(glyphs.size(), 1U);
    const glm::dvec3 c = {1 - 20.5 / 100, 1 - 30.5 / 80, 0.5 / 64};
    EXPECT_LT(glm::distance(glm::dvec3(glyphs[0].from), layout->p_from_c(c)), 1e-6);
    const glm::dvec3 tip = layout->p_from_c(c + glm::dvec3(-1.5 / 100, 0.5 / 80, 0));
    EXPECT_LT(glm::distance(glm::dvec3(glyphs[0].from + glyphs[0].vector), tip), 1e-6)
        << "without motion along time the map is straight, so the arrow ends where the map puts its end";
    const std::vector<scene::Glyph> capped =
        scene::arrows(volume, volume.seeds(), *layout, {.frames = 1000, .cap = 0.09});
    EXPECT_NEAR(glm::length(capped[0].vector), 0.09, 1e-6);
}

TEST(Arrows, LeanAlongTimeByItsVelocity) {
    const volume::Volume volume = volume_with_a_seed();
    for (const auto& row : space::layouts()) {
        const auto layout = row.make({0.45, 1, 0.4});
        const double v_t = 0.8;
        const std::vector<scene::Glyph> glyphs =
            scene::arrows(volume, volume.seeds(), *layout, {.frames = 1, .cap = 1, .time_velocity = v_t});
        ASSERT_EQ(glyphs.size(), 1U);
        // The derivative of the map along the way of the particle.
        const auto place = [&](double frames) {
            return layout->p_from_c(volume.c_of({20 + 1.5 * frames, 30 - 0.5 * frames, v_t * frames}));
        };
        constexpr double step = 1e-4;
        const glm::dvec3 expected = (place(step) - place(-step)) / (2 * step);
        EXPECT_LT(glm::distance(glm::dvec3(glyphs[0].vector), expected), 1e-6) << row.name;
    }
}

TEST(ArrowMesh, ReachesFromZeroToOne) {
    const scene::GlyphMesh mesh = scene::arrow_mesh();
    float low = 1;
    float high = 0;
    for (const scene::GlyphVertex& vertex : mesh.vertices) {
        low = std::min(low, vertex.position.z);
        high = std::max(high, vertex.position.z);
    }
    EXPECT_EQ(low, 0);
    EXPECT_EQ(high, 1);
    for (const std::uint32_t index : mesh.indices) EXPECT_LT(index, mesh.vertices.size());
}

}  // namespace
}  // namespace vvr
