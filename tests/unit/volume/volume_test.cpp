#include "core/volume/volume.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/volume/brick.h"
#include "tests/support/fields.h"

namespace vvr {
namespace {

using test::field_of;

TEST(Volume, KeepsEachFrameWhileItFits) {
    volume::Volume volume({2, 2}, {8});
    for (int i = 0; i < 8; ++i) volume.add(field_of(i, {2, 2}, static_cast<std::uint8_t>(i)));
    EXPECT_EQ(volume.layers(), 8);
    EXPECT_EQ(volume.step(), 1);
    EXPECT_EQ(volume.layer(5).scalar.at(0, 0), 5);
    EXPECT_NEAR(volume.t_of_frame(0), 0.5 / 8, 1e-12);
}

TEST(Volume, JoinsPairsAndLosesNothingThatMoved) {
    volume::Volume volume({2, 2}, {8});
    for (int i = 0; i < 1000; ++i) volume.add(field_of(i, {2, 2}, i == 613 ? 200 : 0));
    EXPECT_LE(volume.layers(), 8);
    EXPECT_GT(volume.layers(), 4);
    EXPECT_EQ(volume.step(), 128);
    std::int64_t next = 0;
    int bright = 0;
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        const volume::Layer& layer = volume.layer(i);
        EXPECT_EQ(layer.first_frame, next);
        EXPECT_NEAR(layer.pts, static_cast<double>(next) / 25, 1e-9);
        next += layer.frames;
        EXPECT_NEAR(layer.last_pts, static_cast<double>(next - 1) / 25, 1e-9);
        if (layer.scalar.at(1, 1) == 200) {
            ++bright;
            EXPECT_EQ(i, 613 / 128);
        }
    }
    EXPECT_EQ(next, 1000);
    EXPECT_EQ(bright, 1);
}

TEST(Volume, ClearsABoxInAllLayers) {
    volume::Volume volume({4, 4}, {.capacity = 8, .keep_owners = true});
    const fields::LabelRun row{1, 0, 4, 7};
    for (int i = 0; i < 5; ++i) volume.add(field_of(i, {4, 4}, 200), {}, std::span(&row, 1));
    volume.clear({1, 1, 3, 2});
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        EXPECT_EQ(volume.layer(i).scalar.count(), 16 - 2) << i;
        EXPECT_EQ(volume.layer(i).scalar.at(2, 1), 0) << i;
        EXPECT_EQ(volume.layer(i).owner.at(2, 1), 0) << i;
        EXPECT_EQ(volume.track_of(volume.layer(i).owner.at(3, 1)), 7U) << i;
    }
}

TEST(Volume, JoinsBandsFromBeforeTheFirstFrameToTheLast) {
    // Covered from frame 5 to frame 10.
    volume::Volume volume({1, 1}, {.capacity = 100, .step = 4, .values = fields::Values::band});
    for (int i = 0; i < 16; ++i) {
        volume.add(
            field_of(i, {1, 1}, static_cast<std::uint8_t>(fields::band_of(i > 5 && i <= 11, i >= 5 && i <= 10))));
    }
    const fields::Band expected[] = {fields::Band::background, fields::Band::newly_covered, fields::Band::uncovered,
                                     fields::Band::background};
    for (std::int64_t i = 0; i < 4; ++i) {
        EXPECT_EQ(static_cast<fields::Band>(volume.layer(i).scalar.at(0, 0)), expected[i]) << i;
    }
}

TEST(Volume, ThinsSeedsAsItGrows) {
    volume::Volume volume({2, 2}, {8, 1, 2});
    for (int i = 0; i < 1000; ++i) {
        fields::Field field = field_of(i, {2, 2}, 0);
        field.seeds = {{0, 0, 1, 0}};
        volume.add(field);
    }
    ASSERT_EQ(volume.seeds().size(), 4U);
    for (const volume::FrameSeed& at : volume.seeds()) EXPECT_EQ(at.frame % 256, 0);
}

fields::Flow uniform_flow(Size size, float u, float v) {
    return {Plane<float>(size, u), Plane<float>(size, v)};
}

TEST(UsedSeeds, AreThoseThatTheirBrickFlags) {
    // Two frames per layer, bricks of three layers: seeds at frames 0, 5, 6 and 13 are those of bricks 0, 0, 1 and 2.
    volume::Volume volume({4, 4}, {100, 2});
    for (int i = 0; i < 16; ++i) {
        fields::Field field = field_of(i, {4, 4});
        if (i == 0 || i == 5 || i == 6 || i == 13)
            field.seeds = {{1, 2, 3, 4, *fields::SeedFlags::parse(i == 5 ? "0" : "101")}};
        volume.add(field);
    }
    const std::vector<volume::Brick> bricks = volume::cut_by(volume.layers(), 3);
    const auto frames = [&](std::int64_t first, const std::optional<fields::SeedFlags>& flags) {
        std::vector<std::int64_t> found;
        for (const volume::FrameSeed& seed : volume::used_seeds(volume, bricks, first, flags))
            found.push_back(seed.frame);
        return found;
    };
    using Frames = std::vector<std::int64_t>;
    EXPECT_EQ(frames(0, {}), (Frames{0, 13}));
    EXPECT_EQ(frames(1, {}), (Frames{6, 13})) << "digits 0, 1 and, from the beginning, 1";
    EXPECT_EQ(frames(0, fields::SeedFlags::parse("1")), (Frames{0, 5, 6, 13}));
    EXPECT_EQ(frames(0, fields::SeedFlags::parse("010")), (Frames{6}));
    EXPECT_EQ(fields::SeedFlags::parse("0010")->text(), "0010");
    for (const char* const wrong : {"", "2", "1 ", "111111111111111111111111111111110"})
        EXPECT_FALSE(fields::SeedFlags::parse(wrong)) << wrong;
}

TEST(Volume, DropsItsFrontAsIfItHadBegunLater) {
    const auto fill = [](volume::Volume& volume, int begin, int end) {
        for (int i = begin; i < end; ++i) {
            fields::Field field = field_of(i, {2, 2}, static_cast<std::uint8_t>(i));
            field.flow = uniform_flow({2, 2}, static_cast<float>(i), 1);
            field.seeds = {{0, 0, static_cast<float>(i), 0}};
            volume.add(field);
        }
    };
    volume::Volume moved({2, 2}, {.capacity = 4, .step = 2, .seed_interval = 3, .span = 4, .keep_flow = true});
    fill(moved, 0, 8);
    moved.drop_front(3);
    EXPECT_EQ(moved.layers(), 1);
    EXPECT_NEAR(moved.t_end(), 0.25, 1e-12) << "of a window of four layers";
    fill(moved, 8, 13);
    volume::Volume fresh({2, 2}, {.capacity = 4, .step = 2, .seed_interval = 3, .span = 4, .keep_flow = true});
    fill(fresh, 6, 13);

    ASSERT_EQ(moved.layers(), fresh.layers());
    EXPECT_EQ(moved.frames(), 7);
    EXPECT_EQ(moved.layer(0).first_frame, 6);
    for (std::int64_t i = 0; i < fresh.layers(); ++i) {
        EXPECT_EQ(moved.layer(i).first_frame, fresh.layer(i).first_frame);
        EXPECT_EQ(moved.layer(i).frames, fresh.layer(i).frames);
        EXPECT_EQ(moved.layer(i).scalar, fresh.layer(i).scalar);
    }
    ASSERT_EQ(moved.seeds().size(), 3U) << "frames 6, 9 and 12";
    ASSERT_EQ(fresh.seeds().size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(moved.seeds()[i].frame, fresh.seeds()[i].frame);
        EXPECT_EQ(moved.seeds()[i].seed, fresh.seeds()[i].seed);
    }
    ASSERT_EQ(moved.flow().layers(), 3U);
    for (const double at : {0.0, 1.5, 3.0, 6.0}) EXPECT_EQ(moved.flow().at({0, 0, at}), fresh.flow().at({0, 0, at}));
    EXPECT_EQ(moved.c_of({0, 0, 3}), fresh.c_of({0, 0, 3}));
}

TEST(Volume, ThinsFlowWithTheSeeds) {
    volume::Volume volume({2, 2}, {.capacity = 8, .step = 1, .seed_interval = 2, .keep_flow = true});
    for (int i = 13; i < 1013; ++i) {
        fields::Field field = field_of(i, {2, 2}, 0);
        // A clip that begins in its middle: flow comes with frames whose index in the clip is even.
        if (i % 2 == 0) {
            field.flow = uniform_flow({2, 2}, static_cast<float>(i), 0);
            field.seeds = {{0, 0, static_cast<float>(i), 0}};
        }
        volume.add(field);
        EXPECT_LE(volume.flow().layers(), 4U);
        EXPECT_EQ(volume.flow().layers(), volume.seeds().size());
    }
    EXPECT_GE(volume.flow().layers(), 3U);
    EXPECT_EQ(volume.flow().bytes(), volume.flow().layers() * 2 * 2 * 4);
    for (const volume::FrameSeed& at : volume.seeds()) {
        EXPECT_EQ(at.seed.u, static_cast<float>(at.frame + 13));
        EXPECT_NEAR(volume.flow().at({0, 0, at.frame}).x, at.seed.u, 1e-3 * at.seed.u) << "flow of the seed's frame";
    }
}

TEST(FlowVolume, IsTrilinear) {
    volume::FlowVolume flow;
    EXPECT_EQ(flow.at({1, 1, 1}), glm::dvec2(0)) << "nothing kept";
    fields::Flow first = uniform_flow({3, 2}, 0, 1);
    first.u.at(1, 0) = 2;
    first.u.at(1, 1) = 4;
    flow.add(10, first);
    flow.add(14, uniform_flow({3, 2}, 8, 3));
    EXPECT_EQ(flow.at({1, 0, 10}), glm::dvec2(2, 1));
    EXPECT_EQ(flow.at({0.5, 0, 10}), glm::dvec2(1, 1));
    EXPECT_EQ(flow.at({1, 0.25, 10}), glm::dvec2(2.5, 1));
    EXPECT_EQ(flow.at({1, 0, 11}), glm::dvec2(2 + 6 / 4.0, 1.5));
    EXPECT_EQ(flow.at({1, 0, 3}), glm::dvec2(2, 1)) << "before the first";
    EXPECT_EQ(flow.at({1, 0, 99}), glm::dvec2(8, 3)) << "after the last";
    EXPECT_EQ(flow.at({-0.5, 0, 10}), flow.at({0, 0, 10})) << "between the outermost pixels' centres and the border";
    EXPECT_EQ(flow.at({2.5, 1.5, 10}), flow.at({2, 1, 10}));
}

TEST(Volume, RefusesAFrameOfAnotherSize) {
    volume::Volume volume({2, 2}, {8});
    EXPECT_THROW(volume.add(field_of(0, {3, 2}, 0)), Error);
    EXPECT_THROW(volume::Volume({2, 2}, {1}), Error);
}

}  // namespace
}  // namespace vvr
