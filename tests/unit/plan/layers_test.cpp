// Layers and bricks of a plan: from the length that a header states and the settings of bricks.
#include <cstdint>
#include <limits>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include "cli/plan/make_plan.h"
#include "tests/support/errors.h"
#include "tests/unit/plan/header.h"

namespace vvr {
namespace {

using app::Time;
using app::TimeScale;

struct LayersCase {
    const char* name;
    app::BrickOptions bricks;
    std::int64_t frames;
    double rate;
    std::int64_t step;
    std::int64_t layers;
    std::int64_t of_bricks;
    bool nonuniform = false;
};

std::ostream& operator<<(std::ostream& out, const LayersCase& row) {
    return out << row.name;
}

class LayersOfAPlan : public testing::TestWithParam<LayersCase> {};

TEST_P(LayersOfAPlan, FollowFromHeaderAndSettings) {
    const LayersCase& row = GetParam();
    app::RenderJob job;
    job.bricks = row.bricks;
    const app::Plan plan = app::make_plan(job, test::header_of(row.frames, row.rate));
    const app::Extent& extent = plan.volume.extent;
    EXPECT_EQ(extent.frames, row.frames);
    EXPECT_EQ(extent.step, row.step);
    EXPECT_EQ(extent.layers, row.layers);
    EXPECT_EQ(extent.bricks, row.of_bricks);
    EXPECT_EQ(plan.volume.nonuniform, row.nonuniform);
    EXPECT_FALSE(plan.volume.series);
}

constexpr Time ten_seconds{10, Time::Unit::seconds};
constexpr Time hundred_frames{100, Time::Unit::frames};

INSTANTIATE_TEST_SUITE_P(
    Plans, LayersOfAPlan,
    testing::Values(LayersCase{"a layer for each frame", {}, 250, 25, 1, 250, 8},
                    LayersCase{"fewer frames than bricks", {}, 5, 25, 1, 5, 5},
                    LayersCase{"frames share layers", {}, 3000, 25, 4, 750, 8},
                    LayersCase{"over two minutes, motion gets more room", {}, 3001, 25, 4, 800, 8, true},
                    LayersCase{"over two minutes, but even", {.time = TimeScale::even}, 3001, 25, 4, 751, 8},
                    LayersCase{"short, but busy", {.time = TimeScale::busy}, 250, 25, 1, 250, 8, true},
                    LayersCase{"a given step means even layers", {.step = 5}, 3001, 25, 5, 601, 8},
                    LayersCase{"a given step doubles until the layers suffice", {.step = 3}, 3001, 25, 6, 501, 8},
                    LayersCase{"few layers", {.max_layers = 100}, 250, 25, 3, 84, 8},
                    LayersCase{"an unknown rate", {}, 9000, 0, 12, 750, 8},
                    LayersCase{"an unknown length", {}, 0, 25, 1, 800, 8},
                    LayersCase{"bricks of 10 s", {.length = ten_seconds}, 1000, 25, 2, 500, 4},
                    LayersCase{"bricks of 100 frames", {.length = hundred_frames}, 1000, 25, 2, 500, 10},
                    LayersCase{"seconds without a rate", {.length = ten_seconds}, 1000, 0, 2, 500, 8},
                    LayersCase{"another number of bricks", {.window = 3}, 250, 25, 1, 250, 3}));

struct WindowCase {
    const char* name;
    app::BrickOptions bricks;
    int keyframes;
    std::int64_t frames;
    double rate;
    std::int64_t step;
    std::int64_t brick_layers;
    std::vector<std::int64_t> key_layers{};
};

TEST(WindowOfAPlan, FollowsFromHeaderAndSettings) {
    for (const WindowCase& row : {
             WindowCase{"10 s", {}, 0, 10'000, 25, 3, 83},
             WindowCase{"an eighth of a short clip", {}, 0, 400, 25, 1, 50},
             WindowCase{"100 frames without a rate", {}, 0, 0, 0, 1, 100},
             WindowCase{"a given length", {.window = 4, .length = hundred_frames}, 2, 10'000, 25, 1, 100, {0, 50}},
             WindowCase{"few layers", {.max_layers = 100, .length = hundred_frames}, 3, 0, 25, 8, 13, {0, 4, 8}},
         }) {
        app::RenderJob job;
        job.bricks = row.bricks;
        job.look.keyframes = row.keyframes;
        job.output.path = "####.png";
        const app::Plan plan = app::make_plan(job, test::header_of(row.frames, row.rate));
        const app::SlidingWindow& window = plan.volume.window;
        EXPECT_TRUE(plan.volume.series) << row.name;
        EXPECT_FALSE(plan.volume.nonuniform) << row.name << ": one scale of time for all pictures";
        EXPECT_EQ(window.bricks, row.bricks.window) << row.name;
        EXPECT_EQ(window.step, row.step) << row.name;
        EXPECT_EQ(window.brick_layers, row.brick_layers) << row.name;
        EXPECT_EQ(window.key_layers, row.key_layers) << row.name;
        EXPECT_EQ(plan.volume.extent.layers, window.layers()) << row.name;
        EXPECT_LE(window.layers(), row.bricks.max_layers + row.bricks.window) << row.name;
    }
}

TEST(WindowOfAPlan, OfSecondsNeedsARate) {
    app::RenderJob job;
    job.bricks.length = ten_seconds;
    job.output.path = "####.png";
    test::expect_error(ErrorCode::option_value, [&] { app::make_plan(job, test::header_of(250, 0)); },
                       {"'gate.avi'", "10 s", "100f"});
}

TEST(MemoryOfAPlan, GrowsWithWhatIsKeptAndHasToBeThere) {
    const auto bytes = [](const app::RenderJob& job, std::int64_t frames = 250) {
        return app::make_plan(job, test::header_of(frames)).volume.extent.bytes;
    };
    app::RenderJob job;
    const std::int64_t usual = bytes(job);
    EXPECT_GT(bytes(job, 500), usual);
    job.picture.size = {3840, 2160};
    EXPECT_GT(bytes(job), usual);
    job = {};
    job.look.show = {app::Part::volume};
    EXPECT_LT(bytes(job), usual) << "without objects";
    EXPECT_NO_THROW(app::check_memory({.bytes = usual}));
    test::expect_error(ErrorCode::memory_too_small,
                       [] { app::check_memory({.bytes = std::numeric_limits<std::int64_t>::max()}); });
}

}  // namespace
}  // namespace vvr
