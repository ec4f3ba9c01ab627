// Association, assignment, looks, sharing and linking: each by itself.
#include "core/tracking/association.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "core/tracking/appearance.h"
#include "core/tracking/event.h"
#include "core/tracking/patch.h"
#include "core/tracking/pixel_history.h"
#include "core/tracking/tracklet.h"
#include "tests/support/planes.h"

namespace vvr {
namespace {

constexpr Size size{80, 60};
constexpr double never = 10;

/// A picture with coloured boxes in it, and the field of them.
struct Stage {
    Plane<std::uint8_t> field = Plane<std::uint8_t>(size);
    Plane<Bgr> colour = Plane<Bgr>(size, {90, 90, 90});

    tracking::FrameView sight() const { return {field, grey_, colour}; }

    void paint(const PixelBox& box, const Bgr& paint) {
        fill(field, box, 200);
        fill(colour, box, paint);
    }

  private:
    Plane<std::uint8_t> grey_;
};

constexpr Bgr red{40, 40, 200};
constexpr Bgr blue{200, 60, 40};

Plane<double> costs_of(const std::vector<std::vector<double>>& rows) {
    Plane<double> costs({static_cast<int>(rows.front().size()), static_cast<int>(rows.size())});
    for (std::size_t j = 0; j < rows.size(); ++j) {
        for (std::size_t i = 0; i < rows[j].size(); ++i)
            costs.at(static_cast<int>(i), static_cast<int>(j)) = rows[j][i];
    }
    return costs;
}

using Columns = std::vector<std::optional<int>>;

TEST(Assign, TakesTheLeastSumAndNotTheLeastFirst) {
    // The first row's best column is what the second row needs more.
    const auto chosen = tracking::assign(costs_of({{1, 2, 9}, {1, 8, 9}, {9, 9, 3}}), never);
    EXPECT_EQ(chosen, (Columns{1, 0, 2}));
}

TEST(Assign, LeavesRowsWithoutAColumnWhereAllCostTooMuch) {
    const auto chosen = tracking::assign(costs_of({{0.2, 3}, {0.3, 3}, {5, 5}}), 1);
    EXPECT_EQ(chosen, (Columns{0, {}, {}}));
    EXPECT_TRUE(tracking::assign(Plane<double>({0, 0}), 1).empty());
}

TEST(Assign, IsTheLeastOfAllPermutations) {
    std::uint32_t random = 7;
    for (int round = 0; round < 50; ++round) {
        std::vector<std::vector<double>> rows(5, std::vector<double>(5));
        for (auto& row : rows) {
            for (double& cost : row) cost = ((random = random * 1664525 + 1013904223) >> 16) % 100;
        }
        std::vector<std::size_t> order{0, 1, 2, 3, 4};
        double least = 1e9;
        do {
            double sum = 0;
            for (std::size_t k = 0; k < 5; ++k) sum += rows[k][order[k]];
            least = std::min(least, sum);
        } while (std::ranges::next_permutation(order).found);
        double sum = 0;
        const auto chosen = tracking::assign(costs_of(rows), 1000);
        for (std::size_t k = 0; k < 5; ++k) sum += rows[k][static_cast<std::size_t>(chosen[k].value())];
        EXPECT_DOUBLE_EQ(sum, least);
    }
}

TEST(Appearance, TellsCoatAndTrousersApart) {
    const auto look = [](const Bgr& coat, const Bgr& trousers) {
        Stage stage;
        stage.paint({10, 10, 20, 25}, coat);
        stage.paint({10, 25, 20, 40}, trousers);
        const tracking::Blobs blobs = tracking::find_blobs(stage.field, {1, 1}, 4);
        return tracking::Appearance(blobs.patches.front(), stage.sight());
    };
    EXPECT_NEAR(tracking::distance(look(red, blue), look(red, blue)), 0, 1e-3);
    EXPECT_GT(tracking::distance(look(red, blue), look(blue, red)), 0.4) << "the same colours in other places";
    EXPECT_LT(tracking::distance(look({40, 40, 190}, blue), look({46, 46, 200}, blue)), 0.25) << "a little more light";
}

struct Tracked {
    tracking::Patch patch;
    tracking::Appearance look;
};

Tracked tracked(const PixelBox& box, const Bgr& colour) {
    Stage stage;
    stage.paint(box, colour);
    tracking::Patch patch = tracking::find_blobs(stage.field, {1, 1}, 4).patches.front();
    tracking::Appearance look(patch, stage.sight());
    return {std::move(patch), look};
}

tracking::PredictedTrack expected(const Tracked& track, const glm::ivec2& shift, bool was_merged = false) {
    return {&track.patch, shift, &track.look, was_merged, {track.patch.box.width(), track.patch.box.height()}};
}

tracking::Assignment associate_with(const Stage& stage, const std::vector<tracking::PredictedTrack>& tracks) {
    const tracking::Blobs blobs = tracking::find_blobs(stage.field, {1, 1}, 4);
    std::vector<tracking::Appearance> looks;
    for (const tracking::Patch& patch : blobs.patches) looks.emplace_back(patch, stage.sight());
    return tracking::associate(tracks, blobs, looks);
}

TEST(Associate, FollowsMotionAndBeginsWhatIsNew) {
    const Tracked one = tracked({10, 10, 18, 30}, red);
    Stage stage;
    stage.paint({14, 10, 22, 30}, red);
    stage.paint({60, 10, 68, 30}, blue);
    const tracking::Assignment result = associate_with(stage, {expected(one, {4, 0})});
    EXPECT_EQ(result.tracks[0], std::vector<std::size_t>{0});
    EXPECT_TRUE(result.tracks[1].empty());
    EXPECT_FALSE(result.fragment_of[1]);
    EXPECT_FALSE(result.split_from[1]);
}

TEST(Associate, LetsTwoShareABlob) {
    const Tracked one = tracked({10, 10, 18, 30}, red);
    const Tracked two = tracked({22, 10, 30, 30}, blue);
    Stage stage;
    stage.paint({13, 10, 21, 30}, red);
    stage.paint({19, 10, 27, 30}, blue);
    const tracking::Assignment result = associate_with(stage, {expected(one, {3, 0}), expected(two, {-3, 0})});
    ASSERT_EQ(result.tracks.size(), 1U);
    EXPECT_EQ(result.tracks[0].size(), 2U);
}

TEST(Associate, TellsByLooksWhoIsWhoWhenTheyPart) {
    const Tracked one = tracked({20, 10, 28, 30}, red);
    const Tracked two = tracked({22, 10, 30, 30}, blue);
    Stage stage;
    stage.paint({14, 10, 22, 30}, blue);
    stage.paint({28, 10, 36, 30}, red);
    const tracking::Assignment result =
        associate_with(stage, {expected(one, {0, 0}, true), expected(two, {0, 0}, true)});
    ASSERT_EQ(result.tracks.size(), 2U);
    EXPECT_EQ(result.tracks[0], std::vector<std::size_t>{1});
    EXPECT_EQ(result.tracks[1], std::vector<std::size_t>{0});
}

TEST(Associate, TakesALegForAPieceAndAnotherPersonForNone) {
    const Tracked one = tracked({10, 10, 20, 40}, red);
    Stage stage;
    stage.paint({10, 10, 20, 24}, red);
    stage.paint({10, 32, 20, 40}, red);
    EXPECT_EQ(associate_with(stage, {expected(one, {0, 0})}).fragment_of[1], 0U);
    Stage wide;
    wide.paint({8, 10, 18, 40}, red);
    wide.paint({26, 10, 36, 40}, blue);
    EXPECT_FALSE(associate_with(wide, {expected(one, {0, 0})}).fragment_of[1]);
}

TEST(ShareBlob, FindsEachByItsLooksAndGivesItItsPixels) {
    Stage before;
    before.paint({10, 10, 18, 40}, red);
    before.paint({40, 12, 48, 42}, blue);
    const tracking::Blobs alone = tracking::find_blobs(before.field, {1, 1}, 4);
    const tracking::Template first(alone.patches[0], before.sight());
    const tracking::Template second(alone.patches[1], before.sight());
    Stage now;
    now.paint({24, 10, 32, 40}, red);
    now.paint({29, 12, 37, 42}, blue);
    const tracking::Patch blob = tracking::find_blobs(now.field, {1, 1}, 4).patches.front();
    const std::vector<const tracking::Template*> templates{&first, &second};
    const std::vector<glm::ivec2> shifts{{13, 0}, {-10, 1}};
    const std::vector<tracking::TemplateMatch> shares = tracking::split_blob(blob, now.sight(), templates, shifts);
    EXPECT_EQ(shares[0].shift, glm::ivec2(14, 0));
    EXPECT_EQ(shares[1].shift, glm::ivec2(-11, 0));
    EXPECT_GT(shares[1].similarity, 0.95) << "it is in front";
    EXPECT_NEAR(shares[0].similarity, 5.0 / 8, 0.1) << "three of its columns are hidden";
    EXPECT_EQ(shares[0].patch.area + shares[1].patch.area, blob.area);
    EXPECT_EQ(shares[1].patch.area, 8 * 30);
}

tracking::Tracklet tracklet(std::size_t number, double begin, double end, double x0, double x1) {
    tracking::Tracklet t;
    t.number = number;
    const double speed = (x1 - x0) / (end - begin);
    t.begin = {{static_cast<std::int64_t>(begin * 25), begin}, {x0, 30}, {speed, 0}, false};
    t.end = {{static_cast<std::int64_t>(end * 25), end}, {x1, 30}, {speed, 0}, false};
    t.length = 20;
    t.area = 160;
    t.appearance = tracked({10, 10, 18, 30}, red).look;
    return t;
}

TEST(Link, JoinsWhatGoesOnBehindAPostAndNothingElse) {
    std::vector<tracking::Tracklet> all{tracklet(0, 0, 4, 10, 50), tracklet(1, 5, 9, 60, 100),
                                        tracklet(2, 5, 9, 62, 20)};
    all[2].appearance = tracked({10, 10, 18, 30}, blue).look;
    const auto next = tracking::link(all);
    EXPECT_EQ(next[0], 1U);
    EXPECT_FALSE(next[1]);
    EXPECT_FALSE(next[2]);
}

TEST(Link, DoesNotJoinWhoLeftThePictureWithWhoComesIn) {
    std::vector<tracking::Tracklet> all{tracklet(0, 0, 4, 10, 50), tracklet(1, 5, 9, 60, 100)};
    all[0].end.at_border = true;
    EXPECT_FALSE(tracking::link(all)[0]);
}

TEST(Link, IsQuickOverDays) {
    std::vector<tracking::Tracklet> all;
    for (std::size_t k = 0; k < 20'000; ++k) {
        const double begin = 5.0 * static_cast<double>(k);
        all.push_back(tracklet(k, begin, begin + 4, 10, k % 2 == 0 ? 50 : 90));
    }
    // Each even one ends where motion leads on, and the next begins there.
    for (std::size_t k = 1; k < all.size(); k += 2) all[k].begin.place.x = 60;
    const auto next = tracking::link(all);
    EXPECT_EQ(next[0], 1U);
    EXPECT_EQ(next[19'998], 19'999U);
}

TEST(Flicker, CountsComingAndGoing) {
    tracking::Flicker flicker;
    Plane<std::uint8_t> on(size);
    on.at(5, 5) = 100;
    const Plane<std::uint8_t> off(size);
    for (int f = 0; f < 40; ++f) flicker.add(f % 2 ? on : off, {f, f / 25.0});
    tracking::Patch patch{.box = {5, 5, 6, 6}, .values = Plane<std::uint8_t>({1, 1}, 1), .area = 1, .centre = {5, 5}};
    EXPECT_NEAR(flicker.of(patch), 20, 2);
    patch.box = {6, 5, 7, 6};
    EXPECT_EQ(flicker.of(patch), 0);
}

TEST(Labels, AreRunsOfRows) {
    tracking::Patch patch{.box = {3, 4, 8, 6}, .values = Plane<std::uint8_t>({5, 2}, 9), .area = 9, .centre = {}};
    patch.values.at(2, 0) = 0;
    tracking::FrameLabels labels;
    tracking::add_runs(patch, 7, labels);
    ASSERT_EQ(labels.runs.size(), 3U);
    EXPECT_EQ(labels.runs[1].row, 4);
    EXPECT_EQ(labels.runs[1].first, 6);
    EXPECT_EQ(labels.runs[1].last, 8);
    EXPECT_EQ(labels.runs[2].track, 7U);
}

TEST(ChooseEvents, KeepsNumbersTrue) {
    std::vector<tracking::Event> events(3);
    for (std::size_t k = 0; k < 3; ++k) events[k].last.seconds = static_cast<double>(k + 1);
    events[1].kind = tracking::EventKind::left;
    events[2].kind = tracking::EventKind::left;
    events[1].by = 0;
    events[2].from = 1;
    const auto chosen = tracking::choose_events(events, {{tracking::EventKind::left}, 1.5});
    ASSERT_EQ(chosen.size(), 2U);
    EXPECT_FALSE(chosen[0].by);
    EXPECT_EQ(chosen[1].from, 0U);
}

}  // namespace
}  // namespace vvr
