// A volume at reduced size: what it keeps of the whole one.
#include "core/scene/reduced_volume.h"

#include <numeric>

#include <gtest/gtest.h>

#include "core/scene/theme.h"
#include "tests/support/fields.h"

namespace vvr {
namespace {

constexpr Size size{8, 6};
constexpr std::size_t mover = 3;
constexpr std::size_t stander = 5;

/// Three layers: an object of the track `mover` at the top left, one of `stander` at the bottom right, and a pixel of
/// none.
volume::Volume three_layers() {
    volume::Volume volume(size, {.capacity = 8, .keep_owners = true});
    for (int i = 0; i < 3; ++i) {
        fields::Field field = test::field_of(i, size, 0);
        field.scalar.at(0, 0) = field.scalar.at(1, 0) = 255;
        field.scalar.at(7, 5) = 200;
        if (i == 2) field.scalar.at(4, 2) = 40;
        const std::vector<fields::LabelRun> owners{{0, 0, 2, mover}, {5, 7, 8, stander}};
        volume.add(field, {}, owners);
    }
    return volume;
}

volume::VoxelStyle style_of(std::size_t track, const volume::Layer& /*layer*/) {
    if (track == mover) return {scene::palette_index(2, scene::ObjectState::moving), 1};
    return {scene::palette_index(0, scene::ObjectState::marked), 300};
}

scene::ReducedVolume reduced(const scene::Block& block) {
    const std::vector<glm::vec4> palette = scene::object_palette(scene::themes().front());
    return scene::reduced(three_layers(), block, scene::default_transfer_function(), palette, style_of);
}

TEST(ReducedVolume, InItsOwnSizeKeepsEachVoxel) {
    const scene::ReducedVolume whole = reduced({});
    ASSERT_EQ(whole.size, size);
    ASSERT_EQ(whole.layers, 3);
    ASSERT_EQ(whole.levels.size(), 8U * 6U * 3U);
    // x_C and y_C run against columns and rows: what is at the top left is last in its layer.
    EXPECT_EQ(whole.values.at(whole.levels[47]), 255);
    EXPECT_NEAR(whole.values.at(whole.levels[0]), 200, 12) << "as near as a level is";
    EXPECT_NEAR(whole.values.at(whole.levels[96 + 3 * 8 + 3]), 40, 8);
    const std::vector<std::uint16_t> a_layer{4 * 300 + 2, 4, 4};
    EXPECT_EQ((std::vector<std::uint16_t>(whole.owners.begin(), whole.owners.begin() + 3)), a_layer);
    EXPECT_EQ(whole.owners.size(), 10U);
    EXPECT_EQ(whole.owners[7], 0) << "a pixel of no object";
}

TEST(ReducedVolume, KeepsWhatABlockHides) {
    const scene::ReducedVolume small = reduced({2, 3});
    ASSERT_EQ(small.size, (Size{4, 3}));
    ASSERT_EQ(small.layers, 1);
    // Two of the four pixels at the top left are filled in each layer, one of those at the bottom right.
    const scene::TransferFunction transfer = scene::default_transfer_function();
    const auto extinction_of = [&](std::size_t voxel) { return transfer.at(small.values.at(small.levels[voxel])).w; };
    EXPECT_NEAR(extinction_of(11), transfer.at(255).w / 2, 3);
    EXPECT_NEAR(extinction_of(0), transfer.at(200).w / 4, 2);
    EXPECT_EQ(std::count_if(small.levels.begin(), small.levels.end(), [](auto level) { return level > 0; }),
              std::ssize(small.owners));
    EXPECT_EQ(small.owners.front(), 4 * 300 + 2);
    EXPECT_EQ(small.owners.back(), 4);
}

TEST(ReducedVolume, OfAnythingElseThanItsSizeHasARest) {
    const scene::ReducedVolume small = reduced({3, 2});
    EXPECT_EQ(small.size, (Size{3, 2}));
    EXPECT_EQ(small.layers, 2);
    EXPECT_EQ(small.levels.size(), 12U);
    EXPECT_EQ(small.block.side, 3);
}

TEST(ReducedVolume, NamesAnObjectWhereMostOfItIs) {
    volume::Volume volume(size, {.capacity = 8, .keep_owners = true});
    fields::Field field = test::field_of(0, size, 0);
    for (int i = 0; i < 4; ++i) field.scalar.at(i, 0) = 200;
    volume.add(field, {}, std::vector<fields::LabelRun>{{0, 0, 3, mover}, {0, 3, 4, stander}});
    const auto mover_alone = [](std::size_t track, const volume::Layer&) {
        return volume::VoxelStyle{scene::palette_index(1, scene::ObjectState::moving),
                                  static_cast<std::uint16_t>(track)};
    };
    const scene::ReducedVolume small = scene::reduced(volume, {4, 1}, scene::default_transfer_function(),
                                                      scene::object_palette(scene::themes().front()), mover_alone);
    EXPECT_EQ(small.owners, std::vector<std::uint16_t>{4 * mover});
}

}  // namespace
}  // namespace vvr
