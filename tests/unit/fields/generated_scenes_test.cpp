#include <algorithm>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include "core/video/scaler.h"
#include "tests/scene/scene.h"
#include "tests/scene/scene_source.h"
#include "tests/scene/y4m.h"

namespace vvr::generator {
namespace {

int grey(Bgr colour) {
    return static_cast<int>(std::lround(0.114 * colour[0] + 0.587 * colour[1] + 0.299 * colour[2]));
}

const Object* find(const Truth& truth, const std::string& name) {
    for (const auto& object : truth.objects) {
        if (object.name == name) return &object;
    }
    return nullptr;
}

std::int64_t pixels_of(const Plane<std::uint8_t>& mask) {
    std::int64_t count = 0;
    for (const auto value : mask.pixels()) count += value != 0;
    return count;
}

TEST(LeftBag, TellsItsStory) {
    const auto scene = make_left_bag();
    const auto facts = left_bag_facts();
    EXPECT_EQ(scene.frames(), 1600);
    EXPECT_TRUE(scene.truth(0).objects.empty());
    const auto before = scene.truth(facts.put_down - 60);
    ASSERT_TRUE(find(before, "person"));
    ASSERT_TRUE(find(before, "bag"));
    EXPECT_GT(find(before, "person")->vx, 1);
    const auto alone = scene.truth(900);
    EXPECT_FALSE(find(alone, "person"));
    ASSERT_TRUE(find(alone, "bag"));
    EXPECT_DOUBLE_EQ(find(alone, "bag")->vx, 0);
    EXPECT_NEAR(find(alone, "bag")->x, facts.x, 1e-9);
    EXPECT_TRUE(scene.truth(1599).objects.empty());
    EXPECT_GT(facts.taken_up, facts.put_down + 500);
}

TEST(LeftBag, MasksAreWhereThePictureDiffers) {
    Options options;
    options.frames = 160;
    const auto scene = make_left_bag(options);
    const auto empty = scene.frame(0);
    for (const int i : {20, 60, 90, 125}) {
        const auto picture = scene.frame(i);
        const auto truth = scene.truth(i);
        std::int64_t seen = 0;
        for (const auto& object : truth.objects) {
            for (int y = 0; y < picture.height(); ++y) {
                for (int x = 0; x < picture.width(); ++x) {
                    if (object.mask.at(x, y) && picture.at(x, y) != empty.at(x, y)) ++seen;
                }
            }
        }
        std::int64_t masked = 0;
        for (const auto& object : truth.objects) masked += pixels_of(object.mask);
        EXPECT_GT(masked, 100) << i;
        EXPECT_GT(seen, masked * 95 / 100) << i;
    }
}

TEST(Scene, IsTheSameEachTime) {
    Options options;
    options.noise = 4;
    EXPECT_TRUE(
        std::ranges::equal(make_walkers(options).frame(100).pixels(), make_walkers(options).frame(100).pixels()));
    Options other = options;
    other.seed = 2;
    EXPECT_FALSE(
        std::ranges::equal(make_walkers(options).frame(100).pixels(), make_walkers(other).frame(100).pixels()));
}

TEST(Scene, NoiseHasItsSigmaAndLightItsDrift) {
    Options options;
    options.noise = 5;
    const auto scene = make_still(options);
    const auto a = scene.frame(1);
    const auto b = scene.frame(2);
    double sum = 0;
    double squares = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const double difference = a.pixels()[i][1] - b.pixels()[i][1];
        sum += difference;
        squares += difference * difference;
    }
    const auto count = static_cast<double>(a.pixels().size());
    EXPECT_NEAR(sum / count, 0, 0.1);
    EXPECT_NEAR(std::sqrt(squares / count / 2), 5, 0.2);

    options.noise = 0;
    options.drift = 20;
    options.jump = -10;
    options.jump_at = 50;
    const auto drifting = make_still(options);
    const auto plain = make_still().frame(0);
    EXPECT_EQ(drifting.frame(0).at(10, 10), plain.at(10, 10));
    EXPECT_NEAR(drifting.frame(99).at(10, 10)[1] - plain.at(10, 10)[1], 10, 1);
}

TEST(ShiftedTexture, MovesByWholePixelsExactly) {
    Options options;
    options.u = 3;
    options.v = -2;
    const auto scene = make_shifted_texture(options);
    const auto a = scene.frame(4);
    const auto b = scene.frame(5);
    for (int j = 10; j < 200; j += 7) {
        for (int i = 10; i < 300; i += 7) EXPECT_EQ(a.at(i, j), b.at(i + 3, j - 2));
    }
    EXPECT_FLOAT_EQ(scene.truth(4).u.at(5, 5), 3);
    EXPECT_FLOAT_EQ(scene.truth(4).v.at(5, 5), -2);
}

TEST(SpinningSphere, FlowCarriesThePattern) {
    const auto scene = make_spinning_sphere();
    const auto a = scene.frame(10);
    const auto b = scene.frame(11);
    const auto truth = scene.truth(10);
    double error = 0;
    double still = 0;
    int count = 0;
    for (int j = 60; j < 230; ++j) {
        for (int i = 110; i < 275; ++i) {
            if (!truth.objects[0].mask.at(i, j)) continue;
            const int x = static_cast<int>(i + std::lround(truth.u.at(i, j)));
            const int y = static_cast<int>(j + std::lround(truth.v.at(i, j)));
            error += std::abs(grey(b.at(x, y)) - grey(a.at(i, j)));
            still += std::abs(grey(b.at(i, j)) - grey(a.at(i, j)));
            ++count;
        }
    }
    EXPECT_LT(error / count, 0.4 * still / count);
}

TEST(OneObjectASecond, StandsWhereTheTruthSays) {
    const auto scene = make_one_object_a_second();
    EXPECT_EQ(scene.truth(0).objects[0].x, scene.truth(24).objects[0].x);
    EXPECT_NE(scene.truth(24).objects[0].x, scene.truth(25).objects[0].x);
    for (int i = 0; i < scene.frames(); i += 25) {
        const auto disc = scene.truth(i).objects[0];
        const auto x = static_cast<int>(std::lround(disc.x));
        const auto y = static_cast<int>(std::lround(disc.y));
        EXPECT_GT(grey(scene.frame(i).at(x, y)), 200);
    }
}

TEST(Walkers, AreSeveralAtOnceAndHideEachOther) {
    const auto scene = make_walkers();
    const auto truth = scene.truth(260);
    EXPECT_GE(truth.objects.size(), 4u);
    Plane<std::uint8_t> seen(scene.size());
    for (const auto& object : truth.objects) {
        for (std::size_t i = 0; i < seen.pixels().size(); ++i) {
            if (!object.mask.pixels()[i]) continue;
            EXPECT_EQ(seen.pixels()[i]++, 0);
        }
    }
}

TEST(TwoWalkersCross, PassEachOther) {
    const auto scene = make_two_walkers_cross();
    EXPECT_EQ(scene.truth(0).objects.size(), 0u);
    const auto before = scene.truth(150).objects;
    const auto after = scene.truth(350).objects;
    ASSERT_EQ(before.size(), 2u);
    ASSERT_EQ(after.size(), 2u);
    EXPECT_LT(before[0].x, before[1].x);
    EXPECT_GT(after[0].x, after[1].x);
    EXPECT_EQ(scene.truth(599).objects.size(), 0u);
}

TEST(FallOnFloor, LiesStillOnTheFloor) {
    const auto scene = make_fall_on_floor();
    const auto facts = fall_on_floor_facts();
    ASSERT_LT(facts.falls, facts.lies);
    ASSERT_LT(facts.lies + 100, facts.gets_up);
    const auto box = [&](int frame) {
        const auto mask = scene.truth(frame).objects.at(0).mask;
        int left = mask.width(), right = 0, top = mask.height(), bottom = 0;
        for (int j = 0; j < mask.height(); ++j) {
            for (int i = 0; i < mask.width(); ++i) {
                if (mask.at(i, j)) {
                    left = std::min(left, i), right = std::max(right, i), top = std::min(top, j),
                    bottom = std::max(bottom, j);
                }
            }
        }
        return std::array{left, right, top, bottom};
    };
    const auto up = box(facts.falls - 1);
    EXPECT_GT(up[3] - up[2], 2 * (up[1] - up[0]));
    const auto down = box(facts.lies);
    EXPECT_GT(down[1] - down[0], 2 * (down[3] - down[2]));
    EXPECT_NEAR((down[0] + down[1]) / 2.0, facts.x, 6);
    EXPECT_NEAR((down[2] + down[3]) / 2.0, facts.y, 8);
    EXPECT_TRUE(std::ranges::equal(scene.frame(facts.lies).pixels(), scene.frame(facts.gets_up - 1).pixels()));
    EXPECT_FALSE(std::ranges::equal(scene.frame(facts.lies).pixels(), scene.frame(facts.gets_up + 3).pixels()));
    EXPECT_TRUE(scene.truth(0).objects.empty());
    EXPECT_TRUE(scene.truth(599).objects.empty());
}

TEST(SceneSource, GivesTheScenesPixels) {
    Options options;
    options.frames = 3;
    options.size = {64, 48};
    const auto scene = make_shifted_texture(options);
    video::SourceOptions wanted;
    wanted.colour = true;
    const auto source = open_scene(scene, wanted);
    video::Scaler scale(*source);
    source->next();
    const auto frame = scale(*source->next());
    EXPECT_EQ(frame.index, 1);
    EXPECT_NEAR(frame.grey.at(20, 20), grey(scene.frame(1).at(20, 20)), 1);
    EXPECT_NEAR(frame.colour.at(20, 20)[2], scene.frame(1).at(20, 20)[2], 2);
}

}  // namespace
}  // namespace vvr::generator
