#include "core/fields/reference.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/fields/median_scene.h"
#include "core/fields/object.h"
#include "core/fields/running_reference.h"
#include "core/media/picture_source.h"
#include "tests/unit/fields/pictures.h"

namespace vvr {
namespace {

TEST(Reference, MedianForgetsWhoPassedBy) {
    std::vector<media::Frame> frames;
    for (int f = 0; f < 9; ++f) {
        frames.push_back(test::texture_frame({40, 7}, 0, 0, 0));
        frames.back().grey.at(4 * f, 3) = 255;
        frames.back().grey.at(4 * f + 1, 3) = 0;
    }
    const fields::Planes reference = fields::median_reference(frames);
    const media::Frame empty = test::texture_frame({40, 7}, 0, 0, 0);
    EXPECT_TRUE(test::same(reference.grey, empty.grey));
    EXPECT_TRUE(reference.colour.empty());
}

TEST(Reference, IsWithoutWhoStoodThereForMostOfTheClip) {
    const PixelBox person{4, 2, 8, 7};
    const PixelBox box{12, 4, 15, 7};  // a box is no living thing
    std::vector<media::Frame> frames;
    for (int f = 0; f < 24; ++f) {
        media::Frame& frame = frames.emplace_back(test::flat_frame({20, 8}, f, 90));
        if (f < 16) fill(frame.grey, person, 200);
        if (f >= 12) fill(frame.grey, box, 10);
    }
    fields::Planes scene = fields::lasting_reference(frames);
    EXPECT_EQ(scene.grey.at(5, 4), 200);
    int looks = 0;
    const auto find = [&](const media::Frame& frame) {
        ++looks;
        return frame.grey.at(5, 4) == 200 ? std::vector{person} : std::vector<PixelBox>();
    };
    fields::look_behind(frames, find, scene);
    EXPECT_TRUE(test::same(scene.grey, Plane<std::uint8_t>({20, 8}, 90)));
    EXPECT_EQ(looks, 8);
    looks = 0;
    fields::look_behind(std::span(frames).subspan(16), find, scene);
    EXPECT_EQ(looks, 1) << "nobody is in the first frame";
}

TEST(Reference, MedianIsTheMiddleValue) {
    std::vector<media::Frame> frames;
    for (int level : {200, 3, 77, 255, 0}) {
        frames.push_back(test::flat_frame({3, 2}, 0, static_cast<std::uint8_t>(level)));
    }
    EXPECT_EQ(fields::median_reference(frames).grey.at(2, 1), 77);
    frames.pop_back();
    EXPECT_EQ(fields::median_reference(frames).grey.at(2, 1), 200) << "of four, the upper of the two in the middle";
    frames.resize(1);
    EXPECT_EQ(fields::median_reference(frames).grey.at(2, 1), 200);
    EXPECT_TRUE(fields::median_reference({}).empty());
}

TEST(Reference, MedianTakesEachChannelByItself) {
    std::vector<media::Frame> frames;
    for (const Bgr& colour : {Bgr{10, 50, 90}, Bgr{20, 60, 70}, Bgr{30, 40, 80}}) {
        frames.push_back(test::flat_frame({5, 4}, 0, 9));
        frames.back().colour = Plane<Bgr>({5, 4}, colour);
    }
    EXPECT_EQ(fields::median_reference(frames).colour.at(4, 3), (Bgr{20, 50, 80}));
}

TEST(Reference, WhatWasLeftForMostOfTheClipIsNotTheScene) {
    std::vector<media::Frame> frames;
    for (int f = 0; f < 31; ++f) {
        frames.push_back(test::flat_frame({6, 4}, f, static_cast<std::uint8_t>(100 + f % 3)));
        frames.back().colour = Plane<Bgr>({6, 4}, {90, 100, 110});
        if (f >= 9 && f < 29) {
            frames.back().grey.at(2, 2) = 160;
            frames.back().colour.at(2, 2) = {90, 160, 110};
        }
        if (f < 2) frames.back().grey.at(4, 1) = 10;  // somebody stood there at the beginning
        if (f < 2) frames.back().colour.at(4, 1) = {10, 10, 10};
    }
    EXPECT_EQ(fields::median_reference(frames).grey.at(2, 2), 160);
    const fields::Planes reference = fields::lasting_reference(frames);
    EXPECT_EQ(reference.colour.at(2, 2), (Bgr{90, 100, 110}));
    EXPECT_NEAR(reference.grey.at(2, 2), 101, 1);
    EXPECT_EQ(reference.colour.at(4, 1), (Bgr{90, 100, 110}));
    for (media::Frame& frame : frames) frame.colour = {};
    EXPECT_NEAR(fields::lasting_reference(frames).grey.at(2, 2), 101, 1);
    EXPECT_NEAR(fields::lasting_reference(frames).grey.at(4, 1), 101, 1);
}

fields::Planes flat(std::uint8_t level) {
    return {Plane<std::uint8_t>({40, 30}, level), {}};
}

TEST(RunningReference, FollowsTheSceneAndNotTheObject) {
    fields::RunningReference running(flat(100));
    Plane<std::uint8_t> object({40, 30});
    object.at(20, 15) = 255;
    for (int f = 0; f < 500; ++f) running.adapt(flat(120), object, {}, f / 25.0);
    EXPECT_EQ(running.now().grey.at(2, 2), 120);
    EXPECT_EQ(running.now().grey.at(20, 15), 100) << "what was left behind is not swallowed";
    EXPECT_EQ(running.now().grey.at(22, 16), 100) << "nor are its soft edges";
}

TEST(RunningReference, KeepsUpWithSlowChanges) {
    fields::RunningReference running(flat(100));
    const Plane<std::uint8_t> nothing({40, 30});
    for (int f = 0; f < 800; ++f) {
        const int level = 100 + f / 10;
        running.adapt(flat(static_cast<std::uint8_t>(level)), nothing, {}, f / 25.0);
        ASSERT_NEAR(running.now().grey.at(5, 5), level, 5) << f;
    }
}

TEST(RunningReference, LightChangesBehindObjectsToo) {
    fields::RunningReference running(flat(100));
    running.adapt(flat(120), Plane<std::uint8_t>({40, 30}, 255), {.gain = 1.2, .offset = 5}, 0);
    EXPECT_EQ(running.now().grey.at(20, 15), 125);
}

/// A square in the middle, as an object shows it.
Plane<std::uint8_t> square(Size picture, std::uint8_t about, std::uint8_t inside) {
    Plane<std::uint8_t> plane(picture, about);
    fill(plane, {20, 20, 40, 40}, inside);
    return plane;
}

/// Tests of times, at the rates of cameras.
class AtRate : public testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(RunningReference, AtRate, testing::Values(1, 5, 12, 25));

TEST_P(AtRate, FollowsTheSceneInSeconds) {
    fields::RunningReference running(flat(100));
    const Plane<std::uint8_t> nothing({40, 30});
    const double rate = GetParam();
    for (int f = 0; f <= 2 * rate; ++f) running.adapt(flat(200), nothing, {}, f / rate);
    EXPECT_NEAR(running.now().grey.at(5, 5), 175, 12);
    for (int f = 0; f <= 8 * rate; ++f) running.adapt(flat(200), nothing, {}, 2 + (f + 1) / rate);
    EXPECT_GT(running.now().grey.at(5, 5), 197);
}

TEST_P(AtRate, AGhostIsLetGoAfterFiveSecondsAndWhatWasLeftIsNot) {
    const Size picture{64, 64};
    const Plane<std::uint8_t> object = square(picture, 0, 120);
    const Plane<std::uint8_t> bare(picture, 100);
    const Plane<std::uint8_t> with_thing = square(picture, 100, 160);
    fields::RunningReference stood({with_thing, {}});  // who stood there while it was learnt has gone
    fields::RunningReference left({bare, {}});
    const double rate = GetParam();
    for (int f = 0; f < 20 * rate; ++f) {
        stood.adapt({bare, {}}, object, {}, f / rate);
        left.adapt({with_thing, {}}, object, {}, f / rate);
        if (f < 4 * rate) {
            ASSERT_EQ(stood.now().grey.at(30, 30), 160) << "too early to know: " << f / rate << " s";
        }
        if (f > 7 * rate) {
            ASSERT_EQ(stood.now().grey.at(30, 30), 100) << f / rate << " s";
        }
    }
    EXPECT_EQ(stood.now().grey.at(20, 20), 100);
    EXPECT_EQ(left.now().grey.at(30, 30), 100);
}

/// The number of frames from which the empty scene is learnt.
/// \param seconds of the clip; none = a live stream
int frames_to_learn(double rate, std::optional<int> seconds) {
    const std::vector<std::uint8_t> pixels(32 * 24, 100);
    std::int64_t read = 0;
    media::MemoryFrames frames{"memory", {32, 24}, media::PixelOrder::grey, rate, 0, {}};
    if (seconds) frames.frames = std::llround(*seconds * rate);
    frames.read = [&](std::int64_t index, media::MemoryFrame& frame) {
        frame = {pixels.data(), 32, static_cast<double>(index) / rate};
        read = index + 1;
        return static_cast<double>(index) < 60 * rate;
    };
    media::MemorySource source(std::move(frames), {});
    fields::FieldOptions options;
    options.reference = std::string("running");
    fields::make_reference(source, options);
    return static_cast<int>(read);
}

TEST_P(AtRate, LearnsTheSceneFromSecondsOrAFewFrames) {
    const double rate = GetParam();
    EXPECT_EQ(frames_to_learn(rate, std::nullopt), std::max(8, static_cast<int>(2 * rate)));
    EXPECT_NEAR(frames_to_learn(rate, 60), 19.84 * rate, 1);
}

/// An empty room: rough, in colour or without, in one light or another.
fields::Planes room(bool colour, int light) {
    fields::Planes planes{
        test::grey_plane({96, 64}, [&](int i, int j) { return light + test::rough_texture(i, j) / 2; }),
        Plane<Bgr>({96, 64})};
    std::ranges::transform(planes.grey.pixels(), planes.colour.pixels().begin(), [&](std::uint8_t grey) {
        return colour ? Bgr{static_cast<std::uint8_t>(grey / 2), grey, static_cast<std::uint8_t>(grey / 2)}
                      : Bgr{grey, grey, grey};
    });
    return planes;
}

fields::Planes with_person(fields::Planes planes, int x) {
    fill(planes.grey, {x, 20, x + 12, 50}, 250);
    fill(planes.colour, {x, 20, x + 12, 50}, {250, 250, 250});
    return planes;
}

/// What a finder that adapts does with pictures of a room.
class NewScene : public testing::TestWithParam<double> {
  protected:
    NewScene() {
        options_.reference = std::string("running");
        finder_.emplace(options_, 24, fields::Reference(room(true, 20)), everywhere_);
    }

    fields::FoundObject see(const fields::Planes& planes) {
        time_ += 1 / GetParam();
        return finder_->find_and_adapt(fields::smoothed(planes.grey, planes.colour, options_.smooth), time_);
    }

    double time() const { return time_; }

  private:
    fields::FieldOptions options_;
    Plane<std::uint8_t> everywhere_;
    std::optional<fields::ObjectFinder> finder_;
    double time_ = 0;
};

INSTANTIATE_TEST_SUITE_P(RunningReference, NewScene, testing::Values(1, 5, 12, 25));

TEST_P(NewScene, InfraredIsLearntAndNothingIsFoundMeanwhile) {
    while (time() < 4) EXPECT_EQ(test::lit(see(room(true, 20)).values), 0);
    const double changed = time();
    fields::FoundObject found;
    while (!found.scene) {
        ASSERT_LT(time(), changed + 20);
        found = see(with_person(room(false, 90), 5 + static_cast<int>(time() * 13) % 60));
        if (!found.scene) {
            EXPECT_TRUE(found.learning);
            EXPECT_EQ(test::lit(found.values), 0);
        }
    }
    EXPECT_FALSE(found.learning);
    EXPECT_NEAR(found.scene->changed, changed + 1 / GetParam(), 1e-9);
    // Where somebody was while it learnt there is a ghost for some seconds.
    for (const double learnt = time(); time() < learnt + 12;) see(room(false, 90));
    EXPECT_EQ(test::lit(see(room(false, 90)).values), 0);
    EXPECT_NEAR(static_cast<double>(test::lit(see(with_person(room(false, 90), 40)).values)), 360, 100);
}

TEST_P(NewScene, ALampAndAnotherViewAreLearntIfTheyStay) {
    while (time() < 4) see(room(true, 20));
    const fields::Planes other{test::grey_plane({96, 64}, [](int i, int j) { return test::rough_texture(j + 500, i); }),
                               room(true, 20).colour};
    fields::FoundObject found;
    while (!found.scene && time() < 40) found = see(other);
    EXPECT_NEAR(found.scene ? found.scene->changed : 0, 4 + 1 / GetParam(), std::max(2.0, 4 / GetParam()));
    EXPECT_EQ(test::lit(see(other).values), 0);
}

TEST_P(NewScene, WhatGoesAgainSoonIsNotLearnt) {
    while (time() < 4) see(room(true, 20));
    while (time() < 8) EXPECT_FALSE(see(room(false, 90)).scene);
    while (time() < 30) {
        const fields::FoundObject found = see(room(true, 20));
        EXPECT_FALSE(found.learning || found.scene);
        EXPECT_EQ(test::lit(found.values), 0);
    }
}

TEST_P(NewScene, APersonIsNone) {
    while (time() < 40) {
        const fields::FoundObject found = see(time() < 4 ? room(true, 20) : with_person(room(true, 20), 40));
        EXPECT_FALSE(found.learning || found.scene);
    }
}

}  // namespace
}  // namespace vvr
