#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/bricks/cells.h"
#include "core/bricks/used_seeds.h"
#include "core/bricks/volume.h"
#include "core/error.h"

namespace vvr {
namespace {

Field frame(int index, Size size, std::uint8_t value) {
    Field field;
    field.index = index;
    field.pts = 0.1 * index;
    field.scalar = Plane<std::uint8_t>(size, value);
    return field;
}

template <class Texel>
std::vector<Texel> texels_of(const BrickLayers& layers, std::int64_t layer) {
    std::vector<Texel> texels(layers.area());
    layers.lay_out(layer, std::span(texels));
    return texels;
}

TEST(Cut, IntoBricksCoversEachLayerOnce) {
    for (const std::int64_t layers : {1, 2, 7, 795, 800}) {
        for (const int k : {1, 2, 8, 32}) {
            std::int64_t next = 0;
            for (const Brick& brick : cut_into(layers, k)) {
                EXPECT_EQ(brick.first, next);
                EXPECT_GE(brick.count, 1);
                next += brick.count;
            }
            EXPECT_EQ(next, layers);
        }
    }
}

TEST(Cut, ByLengthLeavesTheRestToTheLast) {
    EXPECT_EQ(cut_by(7, 3), (std::vector<Brick>{{0, 3}, {3, 3}, {6, 1}}));
    EXPECT_TRUE(cut_by(0, 3).empty());
}

TEST(Cut, IntoPiecesStaysWithinBricks) {
    EXPECT_EQ(cut_into_pieces(std::vector<Brick>{{0, 32}, {32, 33}, {65, 100}}),
              (std::vector<Brick>{{0, 32}, {32, 16}, {48, 17}, {65, 25}, {90, 25}, {115, 25}, {140, 25}}));
    EXPECT_EQ(cut_into_pieces(std::vector<Brick>{{7, 1}}), (std::vector<Brick>{{7, 1}}));
    EXPECT_TRUE(cut_into_pieces(std::vector<Brick>{}).empty());
}

TEST(Volume, KeepsEachFrameWhileItFits) {
    Volume volume({2, 2}, 8);
    for (int i = 0; i < 8; ++i) volume.add(frame(i, {2, 2}, static_cast<std::uint8_t>(i)));
    EXPECT_EQ(volume.layers(), 8);
    EXPECT_EQ(volume.step(), 1);
    EXPECT_EQ(volume.layer(5).scalar.at(0, 0), 5);
    EXPECT_NEAR(volume.t_of_frame(0), 0.5 / 8, 1e-12);
}

/// A field in which some blocks walk through the scene, each in its own way.
Field walkers(int i) {
    constexpr Size size{96, 64};
    Field field = frame(i, size, 0);
    for (int k = 0; k < 4; ++k) {
        const double speed = 0.4 + 0.7 * k;
        const int left = static_cast<int>(speed * i + 20 * std::sin(0.05 * (k + 1) * i)) % size.width;
        const int top = 14 * k;
        for (int j = top; j < top + 12; ++j) {
            for (int x = std::max(0, left); x < std::min(size.width, left + 8); ++x) field.scalar.at(x, j) = 200;
        }
    }
    return field;
}

/// What a layer of some frames loses: pixels in which it shows something, in frames in which nothing is there.
double loss_of(const std::vector<Field>& fields, std::size_t begin, std::size_t end) {
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
double least_loss(const std::vector<Field>& fields, std::size_t layers) {
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
    std::vector<Field> fields;
    for (int i = 0; i < frames; ++i) fields.push_back(walkers(i));
    for (const std::int64_t layers : {40, 80, 160}) {
        Volume volume(fields.front().scalar.size(), layers);
        volume.give_room_to_motion();
        for (const Field& field : fields) volume.add(field, {}, {}, true);
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
    Volume volume({96, 64}, capacity);
    volume.give_room_to_motion();
    const auto visit = [](int i) { return (2000 <= i && i < 2150) || (9000 <= i && i < 9150); };
    for (int i = 0; i < 15'000; ++i) {
        volume.add(visit(i) ? walkers(i) : frame(i, {96, 64}, 0), {}, {}, visit(i));
        ASSERT_LE(volume.layers(), capacity * 3 / 2);
    }
    volume.settle();
    EXPECT_LE(volume.layers(), capacity);
    for (const double begin : {200.0, 900.0}) {
        EXPECT_GT(volume.t_of_seconds(begin + 15) - volume.t_of_seconds(begin), 0.25) << begin;
    }
    // A gap takes little time to add, and little room.
    Volume gap({96, 64}, capacity);
    gap.give_room_to_motion();
    gap.add(walkers(0), {}, {}, true);
    gap.add_gap(1, 10'000'000, 0.1, 0.1);
    gap.add(walkers(10'000'001), {}, {}, true);
    gap.settle();
    EXPECT_EQ(gap.layers(), 3);
    EXPECT_EQ(gap.missing(), 10'000'000);
    Volume even({96, 64}, capacity);
    even.add(walkers(0));
    even.add_gap(1, 10'000'000, 0.1, 0.1);
    EXPECT_LE(even.layers(), capacity);
    EXPECT_EQ(even.missing(), 10'000'000);
    EXPECT_EQ(even.frames(), 10'000'001);
}

TEST(Volume, JoinsPairsAndLosesNothingThatMoved) {
    Volume volume({2, 2}, 8);
    for (int i = 0; i < 1000; ++i) volume.add(frame(i, {2, 2}, i == 613 ? 200 : 0));
    EXPECT_LE(volume.layers(), 8);
    EXPECT_GT(volume.layers(), 4);
    EXPECT_EQ(volume.step(), 128);
    std::int64_t next = 0;
    int bright = 0;
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        const Layer& layer = volume.layer(i);
        EXPECT_EQ(layer.first_frame, next);
        EXPECT_NEAR(layer.pts, 0.1 * static_cast<double>(next), 1e-9);
        next += layer.frames;
        EXPECT_NEAR(layer.last_pts, 0.1 * static_cast<double>(next - 1), 1e-9);
        if (layer.scalar.at(1, 1) == 200) {
            ++bright;
            EXPECT_EQ(i, 613 / 128);
        }
    }
    EXPECT_EQ(next, 1000);
    EXPECT_EQ(bright, 1);
}

TEST(Volume, JoinsBandsFromBeforeTheFirstFrameToTheLast) {
    // Covered from frame 5 to frame 10.
    Volume volume({1, 1}, 100, 4);
    volume.set_values(Values::band);
    for (int i = 0; i < 16; ++i) {
        volume.add(frame(i, {1, 1}, static_cast<std::uint8_t>(band_of(i > 5 && i <= 11, i >= 5 && i <= 10))));
    }
    const Band expected[] = {Band::background, Band::newly_covered, Band::uncovered, Band::background};
    for (std::int64_t i = 0; i < 4; ++i) {
        EXPECT_EQ(static_cast<Band>(volume.layer(i).scalar.at(0, 0)), expected[i]) << i;
    }
}

TEST(Volume, ThinsSeedsAsItGrows) {
    Volume volume({2, 2}, 8, 1, 2);
    for (int i = 0; i < 1000; ++i) {
        Field field = frame(i, {2, 2}, 0);
        field.seeds = {{0, 0, 1, 0}};
        volume.add(field);
    }
    ASSERT_EQ(volume.seeds().size(), 4U);
    for (const FrameSeed& at : volume.seeds()) EXPECT_EQ(at.frame % 256, 0);
}

Flow uniform_flow(Size size, float u, float v) {
    return {Plane<float>(size, u), Plane<float>(size, v)};
}

TEST(UsedSeeds, AreThoseThatTheirBrickFlags) {
    // Two frames a layer, bricks of three layers: seeds at frames 0, 5, 6 and 13 are those of bricks 0, 0, 1 and 2.
    Volume volume({4, 4}, 100, 2);
    for (int i = 0; i < 16; ++i) {
        Field field{i, 0.1 * i, Plane<std::uint8_t>({4, 4}), {}, {}};
        if (i == 0 || i == 5 || i == 6 || i == 13)
            field.seeds = {{1, 2, 3, 4, *SeedFlags::parse(i == 5 ? "0" : "101")}};
        volume.add(field);
    }
    const std::vector<Brick> bricks = cut_by(volume.layers(), 3);
    const auto frames = [&](std::int64_t first, const std::optional<SeedFlags>& flags) {
        std::vector<std::int64_t> found;
        for (const FrameSeed& seed : used_seeds(volume, bricks, first, flags)) found.push_back(seed.frame);
        return found;
    };
    using Frames = std::vector<std::int64_t>;
    EXPECT_EQ(frames(0, {}), (Frames{0, 13}));
    EXPECT_EQ(frames(1, {}), (Frames{6, 13})) << "digits 0, 1 and, from the beginning, 1";
    EXPECT_EQ(frames(0, SeedFlags::parse("1")), (Frames{0, 5, 6, 13}));
    EXPECT_EQ(frames(0, SeedFlags::parse("010")), (Frames{6}));
    EXPECT_EQ(SeedFlags::parse("0010")->text(), "0010");
    for (const char* const wrong : {"", "2", "1 ", "111111111111111111111111111111110"})
        EXPECT_FALSE(SeedFlags::parse(wrong)) << wrong;
}

TEST(Volume, DropsItsFrontAsIfItHadBegunLater) {
    const auto fill = [](Volume& volume, int begin, int end) {
        volume.keep_flow();
        volume.set_span(4);
        for (int i = begin; i < end; ++i) {
            Field field = frame(i, {2, 2}, static_cast<std::uint8_t>(i));
            field.flow = uniform_flow({2, 2}, static_cast<float>(i), 1);
            field.seeds = {{0, 0, static_cast<float>(i), 0}};
            volume.add(field);
        }
    };
    Volume moved({2, 2}, 4, 2, 3);
    fill(moved, 0, 8);
    moved.drop_front(3);
    EXPECT_EQ(moved.layers(), 1);
    EXPECT_NEAR(moved.t_end(), 0.25, 1e-12) << "of a window of four layers";
    fill(moved, 8, 13);
    Volume fresh({2, 2}, 4, 2, 3);
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
    Volume volume({2, 2}, 8, 1, 2);
    volume.keep_flow();
    for (int i = 13; i < 1013; ++i) {
        Field field = frame(i, {2, 2}, 0);
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
    for (const FrameSeed& at : volume.seeds()) {
        EXPECT_EQ(at.seed.u, static_cast<float>(at.frame + 13));
        EXPECT_NEAR(volume.flow().at({0, 0, at.frame}).x, at.seed.u, 1e-3 * at.seed.u) << "flow of the seed's frame";
    }
}

TEST(FlowVolume, IsTrilinear) {
    FlowVolume flow;
    EXPECT_EQ(flow.at({1, 1, 1}), glm::dvec2(0)) << "nothing kept";
    Flow first = uniform_flow({3, 2}, 0, 1);
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
    Volume volume({2, 2}, 8);
    EXPECT_THROW(volume.add(frame(0, {3, 2}, 0)), Error);
    EXPECT_THROW(Volume({2, 2}, 1), Error);
}

TEST(Volume, KeepsTheColourOfTheStrongestFrame) {
    Volume volume({2, 2}, 2);
    for (int i = 0; i < 4; ++i) {
        Field field = frame(i, {2, 2}, 0);
        field.scalar.at(0, 0) = static_cast<std::uint8_t>(i == 1 ? 90 : 10);
        volume.add(field, Plane<Bgr>({2, 2}, {static_cast<std::uint8_t>(i), 100, 200}));
    }
    ASSERT_EQ(volume.step(), 2);
    EXPECT_TRUE(volume.coloured());
    EXPECT_EQ(volume.layer(0).colour.at(0, 0), (Bgr{1, 100, 200}));
    EXPECT_EQ(volume.layer(0).colour.at(1, 1), (Bgr{0, 100, 200})) << "of equals the first";
    EXPECT_EQ(volume.layer(1).colour.at(0, 0), (Bgr{2, 100, 200}));

    const BrickLayers layers(volume, {0, 2});
    EXPECT_TRUE(layers.coloured());
    EXPECT_EQ((texels_of<ColouredTexel>(layers, 1)[3]), (ColouredTexel{200, 100, 1, 90}))
        << "red first, the scalar last, against the image";
    EXPECT_EQ(texels_of<std::uint8_t>(layers, 1)[3], 90);

    EXPECT_THROW(volume.add(frame(4, {2, 2}, 0)), Error) << "colours from the first frame on";
    Volume plain({2, 2}, 2);
    plain.add(frame(0, {2, 2}, 0));
    EXPECT_THROW(plain.add(frame(1, {2, 2}, 0), Plane<Bgr>({2, 2})), Error);
    EXPECT_FALSE(BrickLayers(plain, {0, 1}).coloured());
}

TEST(BrickLayers, RunAgainstTheImageAndHoldTheNeighboursLayers) {
    Volume volume({2, 2}, 8);
    for (int i = 0; i < 4; ++i) {
        Field field = frame(i, {2, 2}, 0);
        field.scalar.at(0, 0) = static_cast<std::uint8_t>(10 + i);  // top left: x_C and y_C near 1
        volume.add(field);
    }
    const BrickLayers layers(volume, {1, 2});
    ASSERT_EQ(layers.count(), 4);
    for (int layer = 0; layer < 4; ++layer) {
        EXPECT_EQ(texels_of<std::uint8_t>(layers, layer)[3], 10 + layer);
        EXPECT_EQ(texels_of<std::uint8_t>(layers, layer)[0], 0);
    }
    EXPECT_EQ(texels_of<std::uint8_t>(BrickLayers(volume, {0, 2}), 0)[3], 10)
        << "the first layer stands again before itself";
    EXPECT_EQ(texels_of<std::uint8_t>(BrickLayers(volume, {2, 2}), 3)[3], 13);
}

TEST(BrickLayers, HoldOnlyTheBoxInWhichSomethingIs) {
    const Size size{100, 60};
    Volume volume(size, 8);
    for (int i = 0; i < 6; ++i) {
        Field field = frame(i, size, 0);
        if (i == 2) field.scalar.at(20, 40) = 200;
        if (i == 3) field.scalar.at(50, 59) = 100;
        volume.add(field);
    }
    const BrickLayers layers(volume, {1, 2});
    // Tiles of 8 by 8 and a pixel around them: columns 15 to 56 and rows 39 to 59 of the image.
    EXPECT_EQ(layers.box(), (PixelBox{100 - 57, 0, 100 - 15, 60 - 39}));
    EXPECT_EQ(layers.area(), 42U * 21U);
    std::vector<std::uint8_t> texels(4 * layers.area(), 7);
    layers.lay_out(0, texels);
    std::size_t lit = 0;
    for (const std::uint8_t texel : texels) lit += texel != 0 ? 1U : 0U;
    EXPECT_EQ(lit, 2U) << "and the neighbours' layers, of which one is there too, are the third and the fourth";
    const auto texel = [&](int layer, int column, int row) {
        const int x = 99 - column - layers.box().left;
        const int y = 59 - row - layers.box().top;
        return texels[static_cast<std::size_t>(layer) * layers.area() +
                      static_cast<std::size_t>(y * layers.box().width() + x)];
    };
    EXPECT_EQ(texel(2, 20, 40), 200);
    EXPECT_EQ(texel(3, 50, 59), 100);

    EXPECT_EQ(BrickLayers(volume, {5, 1}).area(), 1U) << "nothing is in it";
}

TEST(SparsePlane, IsThePlaneItWasMadeOf) {
    std::mt19937 random(11);
    for (const Size size : {Size{1, 1}, Size{8, 8}, Size{37, 19}, Size{64, 9}}) {
        Plane<std::uint8_t> plain(size);
        Plane<std::uint8_t> other(size);
        for (int k = 0; k < 12; ++k) {
            const auto place = [&] { return random() % plain.pixels().size(); };
            plain.pixels()[place()] = static_cast<std::uint8_t>(random());
            other.pixels()[place()] = static_cast<std::uint8_t>(random());
        }
        SparsePlane sparse(plain);
        sparse.keep_greater(SparsePlane(other));
        std::ranges::transform(plain.pixels(), other.pixels(), plain.pixels().begin(), std::ranges::max);
        EXPECT_EQ(sparse.size(), size);
        EXPECT_EQ(sparse.greatest(), std::ranges::max(plain.pixels()));
        EXPECT_EQ(sparse, SparsePlane(plain));
        PixelBox lit;
        for (int j = 0; j < size.height; ++j) {
            for (int i = 0; i < size.width; ++i) {
                ASSERT_EQ(sparse.at(i, j), plain.at(i, j)) << i << ", " << j;
                if (plain.at(i, j) != 0) lit = hull_of(lit, {i, j, i + 1, j + 1});
            }
        }
        EXPECT_TRUE(sparse.box().holds(lit));
        EXPECT_TRUE((PixelBox{0, 0, size.width, size.height}).holds(sparse.box()));
        plain.pixels()[0] = static_cast<std::uint8_t>(plain.pixels()[0] ^ 1);
        EXPECT_NE(sparse, SparsePlane(plain));
    }
    EXPECT_TRUE(SparsePlane(Plane<std::uint8_t>({20, 20})).box().empty());
}

TEST(BrickCells, HoldEveryVoxelWithItsNeighbours) {
    Volume volume({40, 33}, 64);
    for (int i = 0; i < 50; ++i) volume.add(frame(i, {40, 33}, 0));
    Field odd = frame(50, {40, 33}, 0);
    odd.scalar.at(17, 9) = 77;
    volume.add(odd);
    const auto layout = make_box({0.45, 1, 0.4});
    const BrickCells cells = brick_cells(BrickLayers(volume, {0, volume.layers()}), 1, *layout);
    const double x = 1 - 17.5 / 40;
    const double y = 1 - 9.5 / 33;
    int marked = 0;
    for (int t = 0; t < cells.nt(); ++t) {
        for (int j = 0; j < cells.ny(); ++j) {
            for (int i = 0; i < cells.nx(); ++i) {
                const bool holds = cells.range(i, j, t).high == 77;
                marked += holds ? 1 : 0;
                const auto at = [](const std::vector<double>& borders, int cell, double value) {
                    return borders[static_cast<std::size_t>(cell)] <= value &&
                           value < borders[static_cast<std::size_t>(cell) + 1];
                };
                if (at(cells.x, i, x) && at(cells.y, j, y) && t == cells.nt() - 1) {
                    EXPECT_TRUE(holds);
                }
            }
        }
    }
    EXPECT_GE(marked, 1);
    EXPECT_LE(marked, 4);
}

}  // namespace
}  // namespace vvr
