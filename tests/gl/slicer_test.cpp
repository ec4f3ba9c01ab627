#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "gl/volume_slicer.h"
#include "tests/support/fields.h"
#include "tests/support/layouts.h"
#include "tests/support/planes.h"
#include "tests/support/ray_caster.h"
#include "tests/support/volumes.h"

namespace vvr {
namespace {

using test::draw_volume;
using test::Drawn;
using test::Shot;

constexpr Size small{160, 120};

const volume::Volume& balls() {
    static const volume::Volume volume = test::wandering_balls({48, 36}, 96);
    return volume;
}

Shot small_shot() {
    Shot shot;
    shot.options.size = small;
    shot.options.samples = 1;
    shot.options.slices = 600;
    return shot;
}

TEST(Slicer, UniformSlabLetsExpMinusSigmaLThrough) {
    constexpr double sigma = 1.3;
    const volume::Volume volume = test::full_volume({32, 24}, 40);
    const scene::TransferFunction transfer({{0, {0, 0, 0}, sigma}});
    for (const double fov : {0.0, 30.0}) {
        for (const int slices : {100, 400}) {
            Shot shot = small_shot();
            shot.layout = "box";
            shot.transfer = transfer;
            shot.options.slices = slices;
            shot.options.view = {0, 0, fov, 0.04};
            const Drawn drawn = draw_volume(volume, shot);
            // In the middle of the picture the ray crosses the box at right angles: L is its depth.
            const double through = drawn.picture.at(small.width / 2, small.height / 2).x;
            EXPECT_NEAR(through / std::exp(-sigma * 0.55), 1, 0.01) << "fov " << fov << ", slices " << slices;
        }
    }
}

/// \param step of the rays
void expect_picture_of_ray_caster(const Shot& shot, double step) {
    const volume::Volume& volume = balls();
    const Drawn drawn = draw_volume(volume, shot);
    const auto layout = space::make_layout(shot.layout, space::shape_for(volume.size()));
    const Plane<glm::vec4> expected =
        test::cast_rays(volume, *layout, shot.transfer, drawn.camera, small, {1, 1, 1}, step);
    EXPECT_LT(test::mean_difference(drawn.picture, expected), 1.5);
    EXPECT_LT(test::quantile_difference(drawn.picture, expected, 0.001), 12);
    EXPECT_GT(test::max_contrast(expected), 100) << "there is something to see";
}

struct Viewpoint {
    double azimuth;
    double elevation;
    double fov;
};

class EveryView : public testing::TestWithParam<std::tuple<std::string, Viewpoint>> {};

TEST_P(EveryView, AgreesWithTheRayCaster) {
    const auto& [layout_name, at] = GetParam();
    Shot shot = small_shot();
    shot.layout = layout_name;
    shot.options.view = {at.azimuth, at.elevation, at.fov, 0.04};
    expect_picture_of_ray_caster(shot, 0.004);
}

INSTANTIATE_TEST_SUITE_P(
    Views, EveryView,
    testing::Combine(testing::ValuesIn(test::layout_names()),
                     testing::Values(Viewpoint{0, 38, 30}, Viewpoint{0, 0, 30}, Viewpoint{0, 90, 30},
                                     Viewpoint{0, -35, 30}, Viewpoint{45, 20, 30}, Viewpoint{90, 30, 30},
                                     Viewpoint{135, 30, 60}, Viewpoint{180, 25, 30}, Viewpoint{-60, 50, 20},
                                     Viewpoint{-100, 10, 45}, Viewpoint{20, 38, 0}, Viewpoint{-150, -20, 0})),
    [](const auto& tested) {
        const Viewpoint& at = std::get<1>(tested.param);
        const auto word = [](double number) {
            return (number < 0 ? "m" : "") + std::to_string(static_cast<int>(std::abs(number)));
        };
        return std::get<0>(tested.param) + "_" + word(at.azimuth) + "_" + word(at.elevation) + "_" + word(at.fov);
    });

struct Inside {
    std::string name;
    glm::dvec3 eye;
    glm::dvec3 target;
    double fov;  ///< 0 = parallel rays
};

/// A camera anywhere, in the volume too.
space::Camera camera_at(const Inside& at) {
    constexpr double near = 0.01;
    constexpr double far = 4;
    constexpr double half = 0.5;
    const double aspect = static_cast<double>(small.width) / small.height;
    space::Camera camera;
    camera.eye = at.eye;
    camera.forward = glm::normalize(at.target - at.eye);
    camera.view = glm::lookAtLH(at.eye, at.target, glm::dvec3(0, 1, 0));
    camera.perspective = at.fov > 0;
    camera.projection = camera.perspective ? glm::perspectiveLH_NO(glm::radians(at.fov), aspect, near, far)
                                           : glm::orthoLH_NO(-half * aspect, half * aspect, -half, half, 0.0, far);
    return camera;
}

class FromWithin : public testing::TestWithParam<std::tuple<std::string, Inside>> {};

TEST_P(FromWithin, AgreesWithTheRayCaster) {
    const auto& [layout_name, at] = GetParam();
    Shot shot = small_shot();
    shot.layout = layout_name;
    shot.options.camera = camera_at(at);
    shot.options.slices = 1000;  // near the eye the same distance takes more pixels
    expect_picture_of_ray_caster(shot, 0.002);
}

std::string name_of(const testing::TestParamInfo<std::tuple<std::string, Inside>>& tested) {
    return std::get<0>(tested.param) + "_" + std::get<1>(tested.param).name;
}

INSTANTIATE_TEST_SUITE_P(
    Eyes, FromWithin,
    testing::Combine(testing::ValuesIn(test::layout_names()),
                     testing::Values(Inside{"hollow", {0, 0.2, 0.05}, {0, 0.2, 1}, 70},
                                     Inside{"in_the_volume", {-0.4, 0.22, 0.5}, {0.6, 0.2, 0.5}, 60},
                                     Inside{"below_parallel", {0.05, -0.5, 0.2}, {0, 0.2, 0.6}, 0})),
    name_of);
INSTANTIATE_TEST_SUITE_P(
    Nightly, FromWithin,
    testing::Combine(testing::ValuesIn(test::layout_names()),
                     testing::Values(Inside{"hollow_parallel", {0, 0.2, 0.05}, {0.2, 0.2, 1}, 0},
                                     Inside{"towards_the_open_side", {0.1, 0.25, 0.3}, {-1, 0.2, -0.1}, 80},
                                     Inside{"below", {0.05, -0.5, 0.2}, {0, 0.2, 0.6}, 70})),
    name_of);

TEST(Slicer, ManyBricksLookLikeOne) {
    for (const std::string& layout : test::layout_names()) {
        Shot shot = small_shot();
        shot.layout = layout;
        shot.bricks = 1;
        const Drawn one = draw_volume(balls(), shot);
        for (const int bricks : {2, 8, 32}) {
            shot.bricks = bricks;
            EXPECT_LE(test::max_difference(draw_volume(balls(), shot).picture, one.picture), 2)
                << layout << " " << bricks;
        }
    }
}

TEST(Slicer, PictureDoesNotDependOnTheNumberOfSlices) {
    // As it comes out of the box: default transfer function and samples. From 200 slices on, two are at most a voxel
    // apart here; farther apart they would step over things, and no correction of opacity could bring these back.
    const volume::Volume volume = test::wandering_balls({96, 72}, 96);
    for (const std::string& layout : test::layout_names()) {
        Shot shot;
        shot.layout = layout;
        shot.options.size = {320, 240};
        shot.options.slices = 1600;
        const Drawn fine = draw_volume(volume, shot);
        for (const int slices : {200, 400, 800}) {
            shot.options.slices = slices;
            const Drawn drawn = draw_volume(volume, shot);
            EXPECT_LE(test::quantile_difference(drawn.picture, fine.picture, 0.0005), 3) << layout << " " << slices;
            EXPECT_LT(test::mean_difference(drawn.picture, fine.picture), 0.05) << layout << " " << slices;
            if (layout == "horseshoe" || slices > 200) {
                EXPECT_LE(test::max_difference(drawn.picture, fine.picture), 3) << layout << " " << slices;
            }
        }
        EXPECT_GT(test::max_contrast(fine.picture), 150);
    }
}

TEST(Slicer, TilesOfALargePictureFitTogether) {
    // Larger than one tile; the same picture enlarged from a fine one would show any seam as a line of difference.
    Shot shot = small_shot();
    shot.options.size = {2400, 1800};
    shot.options.slices = 100;
    const Plane<glm::vec4> large = draw_volume(balls(), shot).picture;
    double steepest = 0;
    double across_border = 0;
    const int border = static_cast<int>(1536 * 1024 / 2400);
    for (int j = 1; j < 1800; ++j) {
        double step = 0;
        for (int i = 0; i < 2400; ++i) step += std::abs(large.at(i, j).x - large.at(i, j - 1).x);
        if (j % border == 0) {
            across_border = std::max(across_border, step);
        } else {
            steepest = std::max(steepest, step);
        }
    }
    EXPECT_GT(steepest, 0);
    EXPECT_LE(across_border, steepest);
}

TEST(Slicer, DrawsTheSameBytesAgain) {
    EXPECT_TRUE(test::same(draw_volume(balls(), small_shot()).picture, draw_volume(balls(), small_shot()).picture));
}

TEST(Slicer, OneLayerAndOnePixelAreVolumesToo) {
    for (const Size size : {Size{1, 1}, Size{48, 1}, Size{1, 36}, Size{48, 36}}) {
        EXPECT_GT(test::max_contrast(draw_volume(test::full_volume(size, 1), small_shot()).picture), 20);
    }
}

TEST(Slicer, ShowsTheVideosOwnColours) {
    // The left half of the image is orange, the right half green; seen from the front of the box, whose beginning is
    // the image seen from the side, so look along time.
    constexpr Size size{32, 24};
    volume::Volume volume(size, {8});
    for (int f = 0; f < 8; ++f) {
        Plane<Bgr> colour(size, {51, 128, 255});
        fill(colour, {size.width / 2, 0, size.width, size.height}, {26, 204, 51});
        volume.add(test::field_of(f, size, 255), colour);
    }
    Shot shot = small_shot();
    shot.layout = "box";
    shot.options.colour = gl::VolumeColour::own;
    shot.transfer = scene::TransferFunction({{0, {1, 0, 1}, 400}});
    shot.options.view = {-90, 0, 0, 0.04};  // from the volume's beginning
    const Drawn drawn = draw_volume(volume, shot);
    const auto layout = space::make_layout("box", space::shape_for(size));
    const glm::dvec3 left = layout->p_from_c({1 - 6.0 / size.width, 0.5, 0});
    const glm::dvec3 right = layout->p_from_c({1 - 26.0 / size.width, 0.5, 0});
    for (const auto& [place, expected] :
         {std::pair(left, glm::vec3(1, 0.5, 0.2)), std::pair(right, glm::vec3(0.2, 0.8, 0.1))}) {
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn.at(place)[c], expected[c], 0.01);
    }
    EXPECT_LT(drawn.camera.pixel(left, small).x, drawn.camera.pixel(right, small).x)
        << "and it reads as the image does";

    shot.transfer = scene::TransferFunction({{0, {1, 0, 1}, 0}});
    EXPECT_EQ(test::max_contrast(draw_volume(volume, shot).picture), 0) << "opacity is the scalar's";
}

TEST(Slicer, ReliefLightsWhatFacesTheLightAndChangesNoOpacity) {
    const volume::Volume volume = test::wandering_balls({96, 72}, 96);
    Shot shot;
    shot.layout = "horseshoe";
    shot.options.size = {320, 240};
    shot.options.background = glm::vec4(0);
    shot.transfer = scene::TransferFunction({{20, {0.5, 0.5, 0.5}, 0}, {30, {0.5, 0.5, 0.5}, 400}});
    const Plane<glm::vec4> flat = draw_volume(volume, shot).picture;
    shot.options.shading = gl::VolumeShading::relief;
    const Plane<glm::vec4> relief = draw_volume(volume, shot).picture;
    int brighter = 0;
    int darker = 0;
    for (std::size_t i = 0; i < flat.pixels().size(); ++i) {
        ASSERT_NEAR(relief.pixels()[i].w, flat.pixels()[i].w, 2e-5);  // Mesa 25: 1.3e-5
        brighter += relief.pixels()[i].x > flat.pixels()[i].x + 0.02F ? 1 : 0;
        darker += relief.pixels()[i].x < flat.pixels()[i].x - 0.02F ? 1 : 0;
    }
    EXPECT_GT(brighter, 300) << "there are sides to the light";
    EXPECT_GT(darker, 300) << "and from it";
}

/// A slab of volume across the middle of the view, 0.55 thick.
struct Slab {
    std::string layout;
    float front;  ///< z
    double fov;
};

class OpaqueGeometry : public testing::TestWithParam<Slab> {};

TEST_P(OpaqueGeometry, HidesAndIsHidden) {
    const Slab& slab = GetParam();
    const volume::Volume volume = test::full_volume({32, 24}, 40);
    Shot shot = small_shot();
    shot.layout = slab.layout;
    shot.options.view = {0, 0, slab.fov, 0.04};
    shot.transfer = scene::TransferFunction({{0, {0, 0, 1}, 4}});
    shot.options.glyphs.thickness = 0.4F;
    shot.options.glyphs.slow_colour = shot.options.glyphs.fast_colour = {1, 0, 0};
    const auto middle_with_arrow_at = [&](float z) {
        shot.scene.arrows = {{{-0.25F, 0.2F, slab.front + z}, {0.5F, 0, 0}, 1}};
        return draw_volume(volume, shot).picture.at(small.width / 2, small.height / 2);
    };
    const glm::vec4 before = middle_with_arrow_at(-0.03F);
    const glm::vec4 inside = middle_with_arrow_at(0.275F);
    const glm::vec4 behind = middle_with_arrow_at(0.6F);
    EXPECT_LT(before.z, 0.02) << "nothing of the slab before it";
    EXPECT_GT(before.x, 0.5);
    EXPECT_NEAR(inside.z, 1 - std::exp(-4 * (0.275 - 0.022)), 0.03);
    EXPECT_NEAR(behind.z, 1 - std::exp(-4 * 0.55), 0.02);
    EXPECT_GT(inside.x, behind.x);
    EXPECT_GT(behind.x, 0.03) << "it shines through a little";
}

/// A slab of volume that fills the first or the last half of a box, and a frame that stands in its middle.
TEST(StandingFrames, HideAndAreHiddenFromBothSides) {
    constexpr Size size{32, 24};
    constexpr int layers = 40;
    for (const std::string layout : {"box", "horseshoe"}) {
        for (const bool slab_is_first : {true, false}) {
            volume::Volume volume(size, {layers});
            for (int i = 0; i < layers; ++i) {
                // Interpolation reaches half a layer beyond a slab: a layer is free on each side of the frame.
                const bool beside = i == layers / 2 - 1 || i == layers / 2;
                const bool lit = !beside && (i < layers / 2) == slab_is_first;
                volume.add(test::field_of(i, size, lit ? 255 : 0));
            }
            for (const bool from_beginning : {true, false}) {
                Shot shot = small_shot();
                shot.layout = layout;
                shot.bricks = 4;
                shot.transfer = scene::TransferFunction({{0, {0, 0, 1}, 0}, {255, {0, 0, 1}, 40}});
                shot.scene.frames = {{0.5, Plane<Bgr>(size, Bgr{0, 255, 0}), 1, 20}};
                // Along time in the box; the horseshoe is seen from beside its turn.
                const bool box = layout == "box";
                shot.options.view = {(box ? 90.0 : 60.0) * (from_beginning ? -1 : 1), box ? 0.0 : 8.0, 0, 0.04};
                const Drawn drawn = draw_volume(volume, shot);
                const auto map = space::make_layout(layout, space::shape_for(size));
                const glm::vec4 pixel = drawn.at(map->p_from_c({0.5, 0.5, 0.5}));
                const bool hidden = slab_is_first == from_beginning;
                EXPECT_NEAR(pixel.y, hidden ? 0 : 1, 0.02) << layout << slab_is_first << from_beginning;
                EXPECT_NEAR(pixel.z, hidden ? 1 : 0, 0.02) << layout << slab_is_first << from_beginning;
            }
        }
    }
}

TEST(StandingFrames, LieBetweenTheirNeighboursInTheOrder) {
    const auto box = space::make_box(space::shape_for({32, 24}));
    const std::vector<volume::PlacedCells> bricks = {{nullptr, 0, 0.5}, {nullptr, 0.5, 1}};
    const std::vector<double> standing = {1, 0, 0.5};
    const std::vector<gl::DrawnPart> forward = {{true, 1}, {false, 0}, {true, 2}, {false, 1}, {true, 0}};
    EXPECT_EQ(gl::drawing_order(*box, {100, 0, 0}, bricks, standing), forward) << "from beyond the end";
    EXPECT_EQ(gl::drawing_order(*box, {-100, 0, 0}, bricks, standing), std::vector(forward.rbegin(), forward.rend()));
    const std::vector<gl::DrawnPart> alone = {{true, 1}, {true, 2}, {true, 0}};
    EXPECT_EQ(gl::drawing_order(*box, {100, 0, 0}, {}, standing), alone);
    EXPECT_TRUE(gl::drawing_order(*box, {100, 0, 0}, {}, {}).empty());
}

INSTANTIATE_TEST_SUITE_P(Slabs, OpaqueGeometry,
                         testing::Values(Slab{"box", 0, 0}, Slab{"box", 0, 30}, Slab{"horseshoe", 0.45F, 0},
                                         Slab{"horseshoe", 0.45F, 30}),
                         [](const auto& tested) {
                             return tested.param.layout + (tested.param.fov > 0 ? "_perspective" : "_parallel");
                         });

}  // namespace
}  // namespace vvr
