#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>

#include <gtest/gtest.h>

#include "cli/app/render.h"
#include "cli/plan/make_plan.h"
#include "core/scene/slices.h"
#include "gl/renderer.h"
#include "tests/scene/scene_source.h"
#include "tests/support/planes.h"
#include "tests/support/ray_caster.h"
#include "tests/support/volumes.h"

namespace vvr {
namespace {

bool shows_at(const Plane<std::uint8_t>& mask, double column, double row, int reach) {
    for (int j = -reach; j <= reach; ++j) {
        for (int i = -reach; i <= reach; ++i) {
            const int x = std::clamp(static_cast<int>(std::lround(column)) + i, 0, mask.width() - 1);
            const int y = std::clamp(static_cast<int>(std::lround(row)) + j, 0, mask.height() - 1);
            if (mask.at(x, y) != 0) return true;
        }
    }
    return false;
}

struct Look {
    std::string layout;
    double rate;
    double azimuth;
    double elevation;
    double fov;
    double opacity;  ///< factor
    int samples;
};

void PrintTo(const Look& look, std::ostream* out) {
    *out << look.layout << ", " << look.rate << " frames per second, seen from " << look.azimuth << ","
         << look.elevation;
}

class OneObjectASecond : public testing::TestWithParam<Look> {};

// The whole way from frames to layers. Each pixel is traced back to the place and the time that it shows, by the
// layout's map on the CPU alone: there the scene must have had its object, in exactly that frame.
TEST_P(OneObjectASecond, EachPixelTellsItsObjectsFrame) {
    const Look& look = GetParam();
    constexpr Size field{96, 72};
    generator::Options options{.size = field, .frames = static_cast<int>(12 * look.rate), .rate = look.rate};
    const generator::Scene discs = generator::make_one_object_a_second(options);
    media::SourceOptions source_options{.colour = true};
    fields::ClipFields source(generator::open_scene(discs, source_options), {});

    app::RenderJob job;
    job.layout = look.layout;
    job.look.show = {app::Part::volume};
    job.look.opacity = look.opacity;
    job.backend.row = "software";
    job.output.path = "picture.exr";  // so with pixel data
    job.picture.size = {320, 240};
    job.picture.samples = look.samples;
    job.picture.view = {look.azimuth, look.elevation, look.fov, 0.04};
    image::PixelData layers;
    app::Observer observer;
    const app::Plan plan =
        app::make_plan(job, {source.info(), source.field_size(), source.expected_frames(), {}, {}, {}});
    app::render_clip(plan, source, observer,
                     [&](app::FinishedPicture&& finished) { layers = std::move(finished.picture.pixel_data); });
    ASSERT_EQ(layers.frame.size(), job.picture.size);

    const auto layout = space::make_layout(look.layout, space::shape_for(field));
    const space::Camera camera = space::fit_camera(job.picture.view, scene::outline_points(*layout), job.picture.size);
    std::set<int> seconds;
    int seen = 0;
    for (int j = 0; j < job.picture.size.height; ++j) {
        for (int i = 0; i < job.picture.size.width; ++i) {
            const int frame = static_cast<int>(layers.frame.at(i, j));
            if (frame < 0) {
                EXPECT_EQ(frame, -1);
                EXPECT_TRUE(std::isnan(layers.time.at(i, j)) && std::isnan(layers.depth.at(i, j)));
                continue;
            }
            ++seen;
            seconds.insert(static_cast<int>(frame / look.rate));
            ASSERT_EQ(layers.time.at(i, j), static_cast<float>(frame / look.rate));
            const glm::dvec3 c =
                test::c_of_pixel(i, j, static_cast<double>(layers.depth.at(i, j)), camera, *layout, job.picture.size);
            const double column = (1 - c.x) * field.width - 0.5;
            const double row = (1 - c.y) * field.height - 0.5;
            ASSERT_TRUE(shows_at(discs.truth(frame).objects.front().mask, column, row, 2))
                << "pixel " << i << " " << j << ": frame " << frame << " shows nothing at " << column << " " << row;
            ASSERT_LT(std::abs(c.z * options.frames - (frame + 0.5)), 1.001) << "pixel " << i << " " << j;
        }
    }
    EXPECT_EQ(seconds.size(), 12U) << "an object of each second is to be seen";
    EXPECT_GT(seen, 500);
}

INSTANTIATE_TEST_SUITE_P(Looks, OneObjectASecond,
                         testing::Values(Look{"horseshoe", 25, 0, 46, 30, 1, 4}, Look{"horseshoe", 1, 0, 46, 30, 1, 4},
                                         Look{"horseshoe", 5, 20, 30, 0, 0.1, 1}, Look{"box", 25, -30, 20, 30, 1, 4},
                                         Look{"box", 1, 35, 25, 0, 0.1, 1}),
                         [](const auto& tested) { return tested.param.layout + "_" + std::to_string(tested.index); });

/// A renderer with a volume in it.
class Layers : public testing::Test {
  protected:
    Layers() {
        options_.size = {100, 76};
        options_.samples = 1;
        options_.slices = 150;
        options_.view = {0, 0, 0, 0.04};
    }

    image::PixelData draw(const volume::Volume& volume, const scene::TransferFunction& transfer, scene::Scene scene,
                          int bricks = 4) {
        layout_ = space::make_layout(layout_name_, space::shape_for(volume.size()));
        gl::Renderer renderer(*context_, *layout_, options_);
        renderer.set_transfer(transfer);
        gl::BrickWindow window(context_->gl(), *layout_, volume.layers(), 2);
        window.show(volume, volume::cut_into(volume.layers(), bricks));
        renderer.set_scene(std::move(scene));
        camera_ = renderer.camera();
        picture_ = renderer.draw(window);
        image::PixelData layers = renderer.draw_pixel_data(window, scene::TimeTable(volume));
        EXPECT_TRUE(test::same(picture_, renderer.draw(window))) << "the picture stays the same";
        return layers;
    }

    std::string layout_name_ = "box";
    std::unique_ptr<space::Layout> layout_;
    std::unique_ptr<gl::Context> context_ = gl::open_context("software");
    gl::RenderOptions options_;
    space::Camera camera_;
    Plane<glm::vec4> picture_;
};

const scene::TransferFunction thin({{0, {0, 0, 1}, 0.5}});
const scene::TransferFunction thick({{0, {0, 0, 1}, 12}});
const scene::TransferFunction nothing({{0, {}, 0}});

TEST_F(Layers, OfAnEmptySceneAreEmpty) {
    const image::PixelData layers = draw(test::full_volume({32, 24}, 40), nothing, {});
    for (std::size_t i = 0; i < layers.frame.pixels().size(); ++i) {
        ASSERT_EQ(layers.frame.pixels()[i], -1);
        ASSERT_TRUE(std::isnan(layers.time.pixels()[i]));
        ASSERT_TRUE(std::isnan(layers.depth.pixels()[i]));
    }
}

TEST_F(Layers, OfAnArrowAreItsOwnBeforeInAndBehindTheVolume) {
    // Looked at from the front the box's time runs across the picture: its middle is frame 20.
    const volume::Volume volume = test::full_volume({32, 24}, 40);
    options_.glyphs.thickness = 0.4F;
    const auto middle = [&](const scene::TransferFunction& transfer, float z) {
        scene::Scene scene;
        scene.arrows = {{{-0.25F, 0.2F, z}, {0.5F, 0, 0}, 1, 33}};
        const image::PixelData layers = draw(volume, transfer, scene);
        const glm::dvec3 front = {0, 0.2, 0};
        const float eye = static_cast<float>(glm::dot(front - camera_.eye, camera_.forward));
        const float time = layers.time.at(50, 38);
        EXPECT_EQ(time, static_cast<float>(layers.frame.at(50, 38) / 25.0F));
        return glm::vec2(layers.frame.at(50, 38), layers.depth.at(50, 38) - eye);
    };
    for (const scene::TransferFunction& transfer : {thin, thick, nothing}) {
        EXPECT_EQ(middle(transfer, -0.03F).x, 33) << "before it";
    }
    EXPECT_NEAR(middle(thick, -0.03F).y, -0.03, 0.03);
    EXPECT_EQ(middle(thin, 0.6F).x, 33) << "a thin volume shows more of what is behind than of itself";
    EXPECT_NEAR(middle(thin, 0.6F).y, 0.6, 0.03);
    EXPECT_NEAR(middle(thin, 0.3F).y, 0.3, 0.03);
    EXPECT_NEAR(middle(thick, 0.6F).x, 20, 1) << "a thick one itself";
    EXPECT_NEAR(middle(thick, 0.6F).y, 0, 0.01) << "where the ray enters it, if all of it is alike";
    EXPECT_NEAR(middle(thick, 0.3F).x, 20, 1) << "nor does it show what is deep in it";
    EXPECT_EQ(middle(thick, 0.06F).x, 33) << "only what lies near its surface";
}

TEST_F(Layers, OfATracelineRunThroughItsFrames) {
    const volume::Volume volume = test::full_volume({32, 24}, 40);
    scene::Scene scene;
    scene.tracelines = {{{-0.5F, 0.2F, -0.1F}, 0, 1, 1, 4}, {{0.5F, 0.2F, -0.1F}, 1, 1, 1, 24}};
    options_.traces.width = 0.1F;
    const image::PixelData layers = draw(volume, thick, scene);
    const auto frame_at = [&](double x) {
        const glm::dvec2 pixel = camera_.pixel({x, 0.2, -0.1}, options_.size);
        return layers.frame.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
    };
    EXPECT_NEAR(frame_at(-0.49), 4, 1);
    EXPECT_NEAR(frame_at(0), 14, 1);
    EXPECT_NEAR(frame_at(0.49), 24, 1);
}

TEST_F(Layers, OfAStandingFrameAreItsOwnWhereItCountsMost) {
    const volume::Volume volume = test::full_volume({32, 24}, 40);
    scene::Scene scene;
    scene.frames.push_back({0.5, Plane<Bgr>({32, 24}, {40, 50, 60}), 0.5F, 17});
    options_.view = {-90, 0, 0, 0.04};  // along time
    EXPECT_EQ(draw(volume, thick, scene).frame.at(50, 38), 0) << "the half of the volume before it hides it";
    EXPECT_EQ(draw(volume, thin, scene).frame.at(50, 38), 17) << "no slice of it counts as much";
    EXPECT_EQ(draw(volume, nothing, scene).frame.at(50, 38), 17);
    EXPECT_EQ(draw(volume, nothing, scene).frame.at(2, 38), -1) << "beside it";
}

TEST_F(Layers, LinesShowNothing) {
    const volume::Volume volume = test::full_volume({32, 24}, 40);
    scene::Scene scene;
    scene.lines = {{{-0.5F, 0.2F, -0.1F}, {0.5F, 0.2F, -0.1F}, {0, 0, 0, 1}}};
    EXPECT_EQ(draw(volume, nothing, scene).frame.at(50, 38), -1);
    EXPECT_LT(picture_.at(50, 38).x, 0.5) << "but there is one";
}

TEST_F(Layers, TakeOneOfSeveralSamplesAndFitTogetherFromTiles) {
    // With more samples a tile holds fewer pixels: one tile here, several there.
    const volume::Volume volume = test::wandering_balls({48, 36}, 96);
    layout_name_ = "horseshoe";
    options_.view = {10, 40, 30, 0.04};
    options_.size = {1280, 960};
    options_.slices = 200;
    const image::PixelData whole = draw(volume, scene::default_transfer_function(), {});
    options_.samples = 4;
    const image::PixelData tiled = draw(volume, scene::default_transfer_function(), {}, 3);
    int seen = 0;
    int different = 0;
    for (std::size_t i = 0; i < whole.frame.pixels().size(); ++i) {
        seen += whole.frame.pixels()[i] >= 0 ? 1 : 0;
        different += std::abs(whole.frame.pixels()[i] - tiled.frame.pixels()[i]) > 1 ? 1 : 0;
    }
    EXPECT_GT(seen, 20'000);
    EXPECT_LT(different, seen / 500) << "which of two samples is the greater hangs on the last digit here and there";
}

TEST(TimeTable, KnowsTheFramesOfJoinedLayers) {
    volume::Volume volume({2, 2}, {4});
    for (int i = 0; i < 7; ++i) {
        volume.add({100 + i, 10 + (i < 4 ? 0.5 * i : i), Plane<std::uint8_t>({2, 2}), {}, {}});
    }
    ASSERT_EQ(volume.step(), 2);
    const scene::TimeTable times(volume);
    for (int i = 0; i < 7; ++i) {
        EXPECT_EQ(times.at(i).frame, 100 + i);
        EXPECT_EQ(times.at(i).seconds, 10 + (i < 4 ? 0.5 * i : i));
    }
    EXPECT_EQ(times.at(2.4).frame, 102);
    EXPECT_EQ(times.at(-5).frame, 100);
    EXPECT_EQ(times.at(1e6).frame, 106);
}

}  // namespace
}  // namespace vvr
