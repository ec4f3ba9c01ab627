#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/condition/condition_finder.h"

namespace vvr {
namespace {

using condition::Kind;

constexpr Size size{192, 144};
constexpr double rate = 10;  // frames per second

/// A view full of edges: tiles of random levels.
Plane<std::uint8_t> view_of(unsigned seed) {
    std::mt19937 random(seed);
    Plane<std::uint8_t> tiles({size.width / 12, size.height / 12});
    for (std::uint8_t& level : tiles.pixels()) level = static_cast<std::uint8_t>(60 + random() % 130);
    Plane<std::uint8_t> view(size);
    for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i) view.at(i, j) = tiles.at(i / 12, j / 12);
    }
    return view;
}

/// What a finder says of a clip, frame by frame.
class Recording {
  public:
    explicit Recording(const Plane<std::uint8_t>& empty) : empty_(condition::edge_map(empty)) {}

    condition::Verdict add(const Plane<std::uint8_t>& frame) {
        const condition::FrameSigns signs = condition::signs_of(frame);
        return find_(signs, condition::agreement(signs.edges, empty_), count_++ / rate);
    }

    /// With noise of up to so many levels.
    condition::Verdict add_noisy(Plane<std::uint8_t> frame, int noise) {
        for (std::uint8_t& level : frame.pixels()) {
            const int off = static_cast<int>(random_() % (2U * static_cast<unsigned>(noise) + 1)) - noise;
            level = static_cast<std::uint8_t>(std::clamp(level + off, 0, 255));
        }
        last_ = frame;
        return add(frame);
    }

    const Plane<std::uint8_t>& last() const { return last_; }

  private:
    condition::EdgeMap empty_;
    condition::ConditionFinder find_;
    Plane<std::uint8_t> last_;
    std::mt19937 random_{7};
    int count_ = 0;
};

TEST(EdgeMap, KeepsItsAgreementInOtherLight) {
    const Plane<std::uint8_t> view = view_of(1);
    Plane<std::uint8_t> darker = view;
    for (std::uint8_t& level : darker.pixels()) level = static_cast<std::uint8_t>(level / 2 + 10);
    const condition::Agreement same = condition::agreement(condition::edge_map(darker), condition::edge_map(view));
    EXPECT_EQ(same.blocks, 48);
    EXPECT_DOUBLE_EQ(same.share, 1);
    EXPECT_NEAR(same.contrast, 0.5, 0.05);
    const condition::Agreement other = condition::agreement(condition::edge_map(view_of(2)), condition::edge_map(view));
    EXPECT_LT(other.share, 0.2);
}

TEST(EdgeMap, OfAShakingCameraIsShifted) {
    const Plane<std::uint8_t> view = view_of(1);
    Plane<std::uint8_t> shifted = view;
    for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i) shifted.at(i, j) = view.at(std::min(i + 6, size.width - 1), j);
    }
    EXPECT_FALSE(condition::shows(condition::agreement(condition::edge_map(shifted), condition::edge_map(view))));
    EXPECT_TRUE(condition::shows_shifted(condition::edge_map(shifted), condition::edge_map(view)));
    EXPECT_FALSE(condition::shows_shifted(condition::edge_map(view_of(2)), condition::edge_map(view)));
}

TEST(EdgeMap, OfAFlatPictureTellsNothing) {
    const Plane<std::uint8_t> flat(size, 90);
    EXPECT_EQ(condition::agreement(condition::edge_map(view_of(1)), condition::edge_map(flat)).blocks, 0);
    const condition::EdgeMap tiny = condition::edge_map(Plane<std::uint8_t>({5, 3}, 90));
    EXPECT_EQ(condition::agreement(tiny, tiny).blocks, 0);
}

TEST(Condition, APictureThatIsRepeatedForTwoSecondsIsFrozen) {
    Recording recording(view_of(1));
    for (int f = 0; f < 40; ++f) EXPECT_FALSE(recording.add_noisy(view_of(1), 3).repeats) << f;
    for (int f = 0; f < 50; ++f) {
        const condition::Verdict verdict = recording.add(recording.last());
        EXPECT_EQ(verdict.kind, f < 20 ? Kind::normal : Kind::frozen) << f;
        EXPECT_TRUE(verdict.repeats) << f;
    }
    const condition::Verdict after = recording.add_noisy(view_of(1), 3);
    EXPECT_EQ(after.kind, Kind::normal);
    EXPECT_FALSE(after.repeats);
}

// A rate converter repeats single frames.
TEST(Condition, AFrameThatComesTwiceIsNotFrozen) {
    Recording recording(view_of(1));
    for (int f = 0; f < 100; ++f) {
        recording.add_noisy(view_of(1), 3);
        EXPECT_EQ(recording.add(recording.last()).kind, Kind::normal);
    }
}

// Codecs write the same picture again where nothing happens.
TEST(Condition, AQuietSceneIsNotFrozen) {
    Recording recording(view_of(1));
    for (int f = 0; f < 100; ++f) {
        const condition::Verdict verdict = recording.add(view_of(1));
        EXPECT_EQ(verdict.kind, Kind::normal) << f;
        EXPECT_FALSE(verdict.repeats) << f;
    }
}

// A codec sharpens a frozen picture for a while: that belongs to the freeze, and a quiet time before it does not.
TEST(Condition, AFreezeBeginsWhereTheCodecSettles) {
    Recording recording(view_of(1));
    for (int f = 0; f < 100; ++f) recording.add_noisy(view_of(1), 4);
    for (int f = 0; f < 8; ++f) recording.add_noisy(view_of(1), 1);
    condition::Verdict verdict;
    for (int f = 0; f < 40; ++f) verdict = recording.add(recording.last());
    EXPECT_EQ(verdict.kind, Kind::frozen);
    EXPECT_NEAR(verdict.since, 10.1, 0.11);
}

TEST(Condition, ACardWithATextIsNoPicture) {
    Recording recording(view_of(1));
    recording.add(view_of(1));
    Plane<std::uint8_t> card(size, 128);
    fill(card, {40, 60, 150, 66}, 255);
    EXPECT_EQ(recording.add(card).kind, Kind::blank);
    EXPECT_EQ(recording.add(view_of(1)).kind, Kind::normal);
}

TEST(Condition, AnotherViewIsSeenAtOnce) {
    Recording recording(view_of(1));
    EXPECT_EQ(recording.add(view_of(1)).kind, Kind::normal);
    EXPECT_EQ(recording.add(view_of(2)).kind, Kind::turning);
    EXPECT_EQ(recording.add(view_of(1)).kind, Kind::normal);
}

TEST(Condition, ACoveredCameraShowsNoEdges) {
    Recording recording(view_of(1));
    recording.add(view_of(1));
    Plane<std::uint8_t> cover(size);
    for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i) cover.at(i, j) = static_cast<std::uint8_t>(i / 2);
    }
    EXPECT_EQ(recording.add(cover).kind, Kind::covered);
}

// From morning to night all edges change, but slowly.
TEST(Condition, LightThatChangesSlowlyIsNoOtherView) {
    const Plane<std::uint8_t> from = view_of(1);
    const Plane<std::uint8_t> to = view_of(2);
    Recording recording(from);
    for (int f = 0; f <= 600; ++f) {
        Plane<std::uint8_t> frame(size);
        for (std::size_t i = 0; i < frame.pixels().size(); ++i)
            frame.pixels()[i] = static_cast<std::uint8_t>((from.pixels()[i] * (600 - f) + to.pixels()[i] * f) / 600);
        EXPECT_EQ(recording.add_noisy(frame, 2).kind, Kind::normal) << f;
    }
}

/// For how many of its frames a clip of 120 s is in another light.
int frames_in_other_light(double (*level_at)(double seconds)) {
    condition::LightFinder find;
    int found = 0;
    for (int k = 0; k < 120 * rate; ++k) found += find(level_at(k / rate), k / rate) ? 1 : 0;
    return found;
}

TEST(LightFinder, FindsJumpsThatPass) {
    EXPECT_EQ(frames_in_other_light([](double t) { return t >= 20 && t < 30 ? 170.0 : 128.0; }), 100);
    EXPECT_EQ(frames_in_other_light([](double t) { return t >= 20 && t < 30 ? 90.0 : 128.0; }), 100);
    // Not a white picture before a view is there, not the day, and not the usual play of an exposure.
    EXPECT_EQ(frames_in_other_light([](double t) { return t < 0.5 ? 190.0 : 128.0; }), 0);
    EXPECT_EQ(frames_in_other_light([](double t) { return 100 + t; }), 0);
    EXPECT_EQ(frames_in_other_light([](double t) { return static_cast<int>(t) % 2 == 0 ? 118.0 : 138.0; }), 0);
    // What stays is said for a minute, which is too long to be told.
    EXPECT_NEAR(frames_in_other_light([](double t) { return t < 20 ? 128.0 : 170.0; }), 600, 12);
}

TEST(Intervals, GoOnFromFrameToFrame) {
    std::vector<condition::Interval> intervals;
    for (const double begin : {1.0, 1.1, 1.2, 2.0}) lengthen(intervals, {begin, begin + 0.1, Kind::damaged});
    ASSERT_EQ(intervals.size(), 2U);
    EXPECT_DOUBLE_EQ(intervals.front().end, 1.3);
    EXPECT_DOUBLE_EQ(intervals.back().begin, 2.0);
}

}  // namespace
}  // namespace vvr
