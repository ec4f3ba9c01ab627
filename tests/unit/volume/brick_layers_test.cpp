#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/volume/cells.h"
#include "core/volume/volume.h"
#include "tests/support/fields.h"

namespace vvr {
namespace {

using test::field_of;

template <class Texel>
std::vector<Texel> texels_of(const volume::BrickLayers& layers, std::int64_t layer) {
    std::vector<Texel> texels(layers.area());
    layers.fill_texels(layer, std::span(texels));
    return texels;
}

TEST(BrickLayers, RunAgainstTheImageAndHoldTheNeighboursLayers) {
    volume::Volume volume({2, 2}, {8});
    for (int i = 0; i < 4; ++i) {
        fields::Field field = field_of(i, {2, 2}, 0);
        field.scalar.at(0, 0) = static_cast<std::uint8_t>(10 + i);  // top left: x_C and y_C near 1
        volume.add(field);
    }
    const volume::BrickLayers layers(volume, {1, 2});
    ASSERT_EQ(layers.count(), 4);
    for (int layer = 0; layer < 4; ++layer) {
        EXPECT_EQ(texels_of<std::uint8_t>(layers, layer)[3], 10 + layer);
        EXPECT_EQ(texels_of<std::uint8_t>(layers, layer)[0], 0);
    }
    EXPECT_EQ(texels_of<std::uint8_t>(volume::BrickLayers(volume, {0, 2}), 0)[3], 10)
        << "the first layer stands again before itself";
    EXPECT_EQ(texels_of<std::uint8_t>(volume::BrickLayers(volume, {2, 2}), 3)[3], 13);
}

TEST(BrickLayers, HoldOnlyTheBoxInWhichSomethingIs) {
    const Size size{100, 60};
    volume::Volume volume(size, {8});
    for (int i = 0; i < 6; ++i) {
        fields::Field field = field_of(i, size, 0);
        if (i == 2) field.scalar.at(20, 40) = 200;
        if (i == 3) field.scalar.at(50, 59) = 100;
        volume.add(field);
    }
    const volume::BrickLayers layers(volume, {1, 2});
    // Tiles of 8 by 8 and a pixel around them: columns 15 to 56 and rows 39 to 59 of the image.
    EXPECT_EQ(layers.box(), (PixelBox{100 - 57, 0, 100 - 15, 60 - 39}));
    EXPECT_EQ(layers.area(), 42U * 21U);
    std::vector<std::uint8_t> texels(4 * layers.area(), 7);
    layers.fill_texels(0, texels);
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

    EXPECT_EQ(volume::BrickLayers(volume, {5, 1}).area(), 1U) << "nothing is in it";
}

TEST(BrickLayers, GiveAnOwnerItsNeighboursInTimeToo) {
    volume::Volume volume({6, 6}, {.capacity = 8, .keep_owners = true});
    const std::array run{fields::LabelRun{2, 2, 3, 5}};
    for (int i = 0; i < 5; ++i) {
        fields::Field field = field_of(i, {6, 6}, 0);
        if (i == 2) field.scalar.at(2, 2) = 200;
        volume.add(field, {}, i == 2 ? std::span<const fields::LabelRun>(run) : std::span<const fields::LabelRun>());
    }
    const volume::VoxelStyleLookup identify = [](std::size_t track, const volume::Layer&) {
        return volume::VoxelStyle{static_cast<std::uint8_t>(track), 1};
    };
    const volume::BrickLayers layers(volume, {0, 5}, identify);
    std::vector<bool> owned;
    for (std::int64_t layer = 1; layer <= 5; ++layer) {
        owned.push_back(std::ranges::any_of(texels_of<volume::ColouredTexel>(layers, layer),
                                            [](const volume::ColouredTexel& texel) { return texel[0] == 5; }));
    }
    EXPECT_EQ(owned, (std::vector<bool>{false, true, true, true, false}));
}

TEST(Volume, KeepsTheColourOfTheStrongestFrame) {
    volume::Volume volume({2, 2}, {2});
    for (int i = 0; i < 4; ++i) {
        fields::Field field = field_of(i, {2, 2}, 0);
        field.scalar.at(0, 0) = static_cast<std::uint8_t>(i == 1 ? 90 : 10);
        volume.add(field, Plane<Bgr>({2, 2}, {static_cast<std::uint8_t>(i), 100, 200}));
    }
    ASSERT_EQ(volume.step(), 2);
    EXPECT_TRUE(volume.coloured());
    EXPECT_EQ(volume.layer(0).colour.at(0, 0), (Bgr{1, 100, 200}));
    EXPECT_EQ(volume.layer(0).colour.at(1, 1), (Bgr{0, 100, 200})) << "of equals the first";
    EXPECT_EQ(volume.layer(1).colour.at(0, 0), (Bgr{2, 100, 200}));

    const volume::BrickLayers layers(volume, {0, 2});
    EXPECT_TRUE(layers.coloured());
    EXPECT_EQ((texels_of<volume::ColouredTexel>(layers, 1)[3]), (volume::ColouredTexel{200, 100, 1, 90}))
        << "red first, the scalar last, against the image";
    EXPECT_EQ(texels_of<std::uint8_t>(layers, 1)[3], 90);

    EXPECT_THROW(volume.add(field_of(4, {2, 2}, 0)), Error) << "colours from the first frame on";
    volume::Volume plain({2, 2}, {2});
    plain.add(field_of(0, {2, 2}, 0));
    EXPECT_THROW(plain.add(field_of(1, {2, 2}, 0), Plane<Bgr>({2, 2})), Error);
    EXPECT_FALSE(volume::BrickLayers(plain, {0, 1}).coloured());
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
        volume::SparsePlane sparse(plain);
        sparse.keep_maximum(volume::SparsePlane(other));
        std::ranges::transform(plain.pixels(), other.pixels(), plain.pixels().begin(), std::ranges::max);
        EXPECT_EQ(sparse.size(), size);
        EXPECT_EQ(sparse.greatest(), std::ranges::max(plain.pixels()));
        EXPECT_EQ(sparse, volume::SparsePlane(plain));
        PixelBox lit;
        for (int j = 0; j < size.height; ++j) {
            for (int i = 0; i < size.width; ++i) {
                ASSERT_EQ(sparse.at(i, j), plain.at(i, j)) << i << ", " << j;
                if (plain.at(i, j) != 0) lit = bounding_box(lit, {i, j, i + 1, j + 1});
            }
        }
        EXPECT_TRUE(sparse.box().contains(lit));
        EXPECT_TRUE((PixelBox{0, 0, size.width, size.height}).contains(sparse.box()));
        plain.pixels()[0] = static_cast<std::uint8_t>(plain.pixels()[0] ^ 1);
        EXPECT_NE(sparse, volume::SparsePlane(plain));
    }
    EXPECT_TRUE(volume::SparsePlane(Plane<std::uint8_t>({20, 20})).box().empty());
}

TEST(BrickCells, HoldEveryVoxelWithItsNeighbours) {
    volume::Volume volume({40, 33}, {64});
    for (int i = 0; i < 50; ++i) volume.add(field_of(i, {40, 33}, 0));
    fields::Field odd = field_of(50, {40, 33}, 0);
    odd.scalar.at(17, 9) = 77;
    volume.add(odd);
    const auto layout = space::make_box({0.45, 1, 0.4});
    const volume::BrickCells cells = volume::brick_cells(volume::BrickLayers(volume, {0, volume.layers()}), 1, *layout);
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
