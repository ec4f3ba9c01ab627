#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "gl/renderer.h"
#include "tests/support/fields.h"
#include "tests/support/layouts.h"
#include "tests/support/planes.h"
#include "tests/support/ray_caster.h"
#include "tests/support/volumes.h"

namespace vvr {
namespace {

constexpr Size field{48, 36};
constexpr int brick_layers = 8;
constexpr int k = 4;

using Change = std::function<void(std::int64_t layer, Plane<std::uint8_t>& scalar)>;

/// Layers `begin` to `end` of a clip, changed.
volume::Volume part_of(
    const volume::Volume& clip, std::int64_t begin, std::int64_t end, const Change& change = [](auto, auto&) {}) {
    volume::Volume part(field, {clip.layers()});
    for (std::int64_t i = begin; i < end; ++i) {
        fields::Field of = test::field_of(i, test::whole(clip.layer(i).scalar));
        change(i, of.scalar);
        part.add(of);
    }
    return part;
}

/// A volume in which the layers of a brick look otherwise, but for the first and the last.
volume::Volume otherwise(const volume::Volume& volume, const volume::Brick& brick) {
    return part_of(volume, 0, volume.layers(), [&](std::int64_t layer, Plane<std::uint8_t>& scalar) {
        if (layer <= brick.first || layer >= brick.first + brick.count - 1) return;
        std::ranges::replace_if(
            scalar.pixels(), [](std::uint8_t value) { return value > 150; }, std::uint8_t{255});
    });
}

class MovingWindow : public testing::TestWithParam<std::string> {
  protected:
    MovingWindow() { options_.size = {160, 120}; }

    gl::Renderer renderer() {
        gl::Renderer made(*context_, *layout_, options_);
        made.set_transfer(scene::default_transfer_function());
        return made;
    }

    gl::BrickWindow window(std::int64_t layers, int textures) { return {context_->gl(), *layout_, layers, textures}; }

    /// Bricks `first` to `last` of the clip, in a window that has shown nothing else.
    Plane<glm::vec4> fresh(int first, int last) {
        const volume::Volume part = part_of(clip_, first * brick_layers, (last + 1) * brick_layers);
        gl::BrickWindow shown = window(k * brick_layers, k);
        shown.show(part, volume::cut_by(part.layers(), brick_layers));
        return renderer().draw(shown);
    }

    /// The bricks before the newest: as they are, or otherwise but for their ends.
    enum class Older { same, otherwise };

    void expect_fresh_pictures(Older older) {
        gl::Renderer drawing = renderer();
        gl::BrickWindow moving = window(k * brick_layers, k);
        Plane<glm::vec4> before;
        for (int newest = 0; newest < 9; ++newest) {
            const int oldest = std::max(0, newest - k + 1);
            volume::Volume part = part_of(clip_, oldest * brick_layers, (newest + 1) * brick_layers);
            const std::vector<volume::Brick> bricks = volume::cut_by(part.layers(), brick_layers);
            if (older == Older::otherwise) {
                for (int i = oldest; i < newest; ++i)
                    part = otherwise(part, bricks[static_cast<std::size_t>(i - oldest)]);
            }
            moving.show(part, bricks, oldest);
            const Plane<glm::vec4> moved = drawing.draw(moving);
            EXPECT_TRUE(test::same(moved, fresh(oldest, newest))) << "brick " << newest;
            if (newest > 0) {
                EXPECT_GT(test::max_difference(moved, before), 50) << "it moves";
            }
            before = moved;
        }
    }

    volume::Volume clip_ = test::wandering_balls(field, 9 * brick_layers);
    std::unique_ptr<space::Layout> layout_ = space::make_layout(GetParam(), space::shape_for(field));
    std::unique_ptr<gl::Context> context_ = gl::open_context("software");
    gl::RenderOptions options_;
};

TEST_P(MovingWindow, IsAFreshOneByteForByte) {
    expect_fresh_pictures(Older::same);
}

TEST_P(MovingWindow, OfAWholeVolumeIsTheSameFromAnyNumberOfTextures) {
    const volume::Volume volume = part_of(clip_, 0, k * brick_layers);
    const std::vector<volume::Brick> bricks = volume::cut_by(volume.layers(), 7);
    const auto count = static_cast<int>(bricks.size());
    for (const gl::VolumeShading shading : {gl::VolumeShading::none, gl::VolumeShading::relief}) {
        options_.shading = shading;
        gl::Renderer drawing = renderer();
        gl::BrickWindow ample = window(volume.layers(), 2 * count);
        ample.show(volume, bricks);
        const Plane<glm::vec4> expected = drawing.draw(ample);
        for (const int textures : {count, 1, 2, 3}) {
            gl::BrickWindow shown = window(volume.layers(), textures);
            shown.show(volume, bricks);
            for (int again = 0; again < 2; ++again) {
                EXPECT_TRUE(test::same(drawing.draw(shown), expected)) << textures << " textures";
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
    expect_fresh_pictures(Older::otherwise);
}

INSTANTIATE_TEST_SUITE_P(Layouts, MovingWindow, testing::ValuesIn(test::layout_names()));

}  // namespace
}  // namespace vvr
