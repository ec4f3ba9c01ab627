#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/volume/volume.h"
#include "tests/support/fields.h"
#include "tests/support/planes.h"

namespace vvr {
namespace {

using test::field_of;

/// A field in which some blocks walk through the scene, each in its own way.
fields::Field walkers(int i) {
    constexpr Size size{96, 64};
    fields::Field field = field_of(i, size, 0);
    for (int k = 0; k < 4; ++k) {
        const double speed = 0.4 + 0.7 * k;
        const int left = static_cast<int>(speed * i + 20 * std::sin(0.05 * (k + 1) * i)) % size.width;
        const int top = 14 * k;
        fill(field.scalar, {left, top, left + 8, top + 12}, 200);
    }
    return field;
}

/// What a layer of some frames loses: pixels in which it shows something, in frames in which nothing is there.
double loss_of(const std::vector<fields::Field>& fields, std::size_t begin, std::size_t end) {
    Plane<std::uint8_t> all(fields.front().scalar.size());
    double there = 0;
    for (std::size_t i = begin; i < end; ++i) {
        const auto& pixels = fields[i].scalar.pixels();
        for (std::size_t p = 0; p < pixels.size(); ++p) {
            all.pixels()[p] = std::max(all.pixels()[p], pixels[p]);
            there += pixels[p] != 0 ? 1 : 0;
        }
    }
    const auto shown = std::ssize(all.pixels()) - std::ranges::count(all.pixels(), std::uint8_t{0});
    return static_cast<double>(shown) * static_cast<double>(end - begin) - there;
}

/// The least that a division into so many layers can lose: dynamic programming over all of them.
double least_loss(const std::vector<fields::Field>& fields, std::size_t layers) {
    const std::size_t frames = std::min<std::size_t>(fields.size(), 1000);
    constexpr double none = std::numeric_limits<double>::infinity();
    std::vector<std::vector<double>> loss(frames, std::vector<double>(frames + 1, none));
    for (std::size_t begin = 0; begin < frames; ++begin) {
        // Much longer ones are in no good division.
        const std::size_t longest = std::min(frames, begin + 8 * frames / layers);
        for (std::size_t end = begin + 1; end <= longest; ++end) loss[begin][end] = loss_of(fields, begin, end);
    }
    std::vector<double> best(frames + 1, none);
    best[0] = 0;
    for (std::size_t k = 0; k < layers; ++k) {
        std::vector<double> next(frames + 1, none);
        for (std::size_t end = 1; end <= frames; ++end) {
            for (std::size_t begin = 0; begin < end; ++begin) {
                next[end] = std::min(next[end], best[begin] + loss[begin][end]);
            }
        }
        best = std::move(next);
    }
    return best[frames];
}

TEST(Volume, DividesTimeNearlyAsWellAsCanBeInOnePass) {
    constexpr int frames = 240;
    std::vector<fields::Field> fields;
    for (int i = 0; i < frames; ++i) fields.push_back(walkers(i));
    for (const std::int64_t layers : {40, 80, 160}) {
        volume::Volume volume(fields.front().scalar.size(), {.capacity = layers, .nonuniform = true});
        for (const fields::Field& field : fields) volume.add(field, {}, {}, true);
        volume.settle();
        ASSERT_EQ(volume.layers(), layers);
        double loss = 0;
        std::size_t next = 0;
        for (std::int64_t i = 0; i < layers; ++i) {
            const auto end = next + static_cast<std::size_t>(volume.layer(i).frames);
            loss += loss_of(fields, next, end);
            next = end;
        }
        EXPECT_EQ(next, fields.size());
        EXPECT_LE(loss, 1.1 * least_loss(fields, static_cast<std::size_t>(layers))) << layers;
    }
}

TEST(Volume, GivesItsRoomToMotionAndHoldsNotManyMore) {
    constexpr std::int64_t capacity = 100;
    volume::Volume volume({96, 64}, {.capacity = capacity, .nonuniform = true});
    const auto visit = [](int i) { return (2000 <= i && i < 2150) || (9000 <= i && i < 9150); };
    for (int i = 0; i < 15'000; ++i) {
        volume.add(visit(i) ? walkers(i) : field_of(i, {96, 64}, 0), {}, {}, visit(i));
        ASSERT_LE(volume.layers(), capacity * 3 / 2);
    }
    volume.settle();
    EXPECT_LE(volume.layers(), capacity);
    for (const double begin : {80.0, 360.0}) {
        EXPECT_GT(volume.t_of_seconds(begin + 6) - volume.t_of_seconds(begin), 0.25) << begin;
    }
    // A gap takes little time to add, and little room.
    volume::Volume gap({96, 64}, {.capacity = capacity, .nonuniform = true});
    gap.add(walkers(0), {}, {}, true);
    gap.add_gap(1, 10'000'000, 0.04, 0.04);
    gap.add(walkers(10'000'001), {}, {}, true);
    gap.settle();
    EXPECT_EQ(gap.layers(), 3);
    EXPECT_EQ(gap.missing(), 10'000'000);
    volume::Volume even({96, 64}, {capacity});
    even.add(walkers(0));
    even.add_gap(1, 10'000'000, 0.04, 0.04);
    EXPECT_LE(even.layers(), capacity);
    EXPECT_EQ(even.missing(), 10'000'000);
    EXPECT_EQ(even.frames(), 10'000'001);
}

TEST(Volume, KeepsAGapApartFromTheMotionBesideIt) {
    // Motion whose pixels are the empty scene's costs nothing to merge with a layer in which there is nothing.
    constexpr std::int64_t capacity = 30;
    volume::Volume volume({96, 64}, {.capacity = capacity, .nonuniform = true});
    const auto add = [&](int frame, bool shows) {
        volume.add(shows ? walkers(frame) : field_of(frame, {96, 64}, 0), {}, {}, true);
    };
    for (int i = 0; i < 100; ++i) add(i, i < 99);
    volume.add_gap(100, 10'000, 4, 0.04);
    for (int i = 10'100; i < 10'200; ++i) add(i, i > 10'100);
    volume.settle();
    std::int64_t gaps = 0;
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        const volume::Layer& layer = volume.layer(i);
        if (layer.missing == 0) continue;
        ++gaps;
        EXPECT_EQ(layer.missing, layer.frames);
    }
    EXPECT_EQ(gaps, 1);
    EXPECT_TRUE(volume::compressed_stretches(volume).empty()) << "a gap is no time in which nothing moved";
}

}  // namespace
}  // namespace vvr
