#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "gl/renderer.h"
#include "tests/support/ray_caster.h"
#include "tests/support/volumes.h"

namespace vvr {
namespace {

constexpr Size field{48, 36};
constexpr int brick_layers = 8;
constexpr int k = 4;

using Change = std::function<void(std::int64_t layer, Plane<std::uint8_t>& scalar)>;

/// Layers `begin` to `end` of a clip, changed.
Volume part_of(
    const Volume& clip, std::int64_t begin, std::int64_t end, const Change& change = [](auto, auto&) {}) {
    Volume part(field, clip.layers());
    for (std::int64_t i = begin; i < end; ++i) {
        Field of;
        of.index = i;
        of.scalar = test::whole(clip.layer(i).scalar);
        change(i, of.scalar);
        part.add(of);
    }
    return part;
}

/// A volume in which a brick's own layers, but for the first and the last, look otherwise.
Volume otherwise(const Volume& volume, const Brick& brick) {
    return part_of(volume, 0, volume.layers(), [&](std::int64_t layer, Plane<std::uint8_t>& scalar) {
        if (layer <= brick.first || layer >= brick.first + brick.count - 1) return;
        std::ranges::replace_if(
            scalar.pixels(), [](std::uint8_t value) { return value > 150; }, std::uint8_t{255});
    });
}

class MovingWindow : public testing::TestWithParam<std::string> {
  protected:
    MovingWindow() {
        options_.size = {160, 120};
        options_.ring = k;
        options_.window_layers = k * brick_layers;
    }

    Renderer renderer() {
        Renderer made(*context_, *layout_, options_);
        made.set_transfer(default_transfer_function());
        return made;
    }

    /// Bricks `first` to `last` of the clip, drawn by a renderer that has seen nothing else.
    Plane<glm::vec4> fresh(int first, int last) {
        const Volume part = part_of(clip_, first * brick_layers, (last + 1) * brick_layers);
        Renderer drawing = renderer();
        for (int i = 0; i <= last - first; ++i)
            drawing.push_brick(i, BrickLayers(part, {i * brick_layers, brick_layers}));
        return drawing.draw();
    }

    /// What of a brick is told when its ends are renewed; the rest is something else.
    enum class Told { all, ends };

    void expect_fresh_pictures(Told told) {
        Renderer moving = renderer();
        Plane<glm::vec4> before;
        for (int newest = 0; newest < 9; ++newest) {
            const int oldest = std::max(0, newest - k + 1);
            const Volume window = part_of(clip_, oldest * brick_layers, (newest + 1) * brick_layers);
            const auto brick = [&](int number) { return Brick{(number - oldest) * brick_layers, brick_layers}; };
            const auto renew = [&](int number) {
                if (told == Told::all) return moving.renew_ends(number, BrickLayers(window, brick(number)));
                const Volume other = otherwise(window, brick(number));
                moving.renew_ends(number, BrickLayers(other, brick(number)));
            };
            moving.push_brick(newest, BrickLayers(window, brick(newest)));
            if (newest > 0) renew(newest - 1);
            if (oldest > 0) renew(oldest);
            const Plane<glm::vec4> moved = moving.draw();
            EXPECT_TRUE(std::ranges::equal(moved.pixels(), fresh(oldest, newest).pixels())) << "brick " << newest;
            if (newest > 0) {
                EXPECT_GT(test::max_difference(moved, before), 50) << "it moves";
            }
            before = moved;
        }
    }

    Volume clip_ = test::wandering_balls(field, 9 * brick_layers);
    std::unique_ptr<Layout> layout_ = make_layout(GetParam(), shape_for(field));
    std::unique_ptr<Context> context_ = open_context("software");
    RenderOptions options_;
};

TEST_P(MovingWindow, IsAFreshOneByteForByte) {
    expect_fresh_pictures(Told::all);
}

TEST_P(MovingWindow, OfAWholeVolumeIsTheSameFromAnyNumberOfTextures) {
    const Volume volume = part_of(clip_, 0, k * brick_layers);
    const std::vector<Brick> bricks = cut_by(volume.layers(), 7);
    const auto count = static_cast<int>(bricks.size());
    for (const VolumeShading shading : {VolumeShading::none, VolumeShading::relief}) {
        options_.shading = shading;
        Renderer pushing = renderer();
        pushing.set_window(count, volume.layers());
        for (int i = 0; i < count; ++i) {
            pushing.push_brick(i, BrickLayers(volume, bricks[static_cast<std::size_t>(i)]));
        }
        const Plane<glm::vec4> expected = pushing.draw();
        Renderer showing = renderer();
        for (const int textures : {count, 1, 2, 3}) {
            showing.show(volume, bricks, textures);
            for (int again = 0; again < 2; ++again) {
                EXPECT_TRUE(std::ranges::equal(showing.draw().pixels(), expected.pixels())) << textures << " textures";
            }
        }
    }
}

TEST_P(MovingWindow, LooksOnlyAtTheEndsOfABrickThatIsThere) {
    // Something in its corners, so that the box of what isn't 0 stays the same.
    clip_ = part_of(clip_, 0, clip_.layers(), [](std::int64_t, Plane<std::uint8_t>& scalar) {
        scalar.at(0, 0) = 1;
        scalar.at(field.width - 1, field.height - 1) = 1;
    });
    expect_fresh_pictures(Told::ends);
}

INSTANTIATE_TEST_SUITE_P(Layouts, MovingWindow, testing::Values("horseshoe", "box"));

}  // namespace
}  // namespace vvr
