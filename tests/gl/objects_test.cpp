#include "cli/observe/objects.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "core/scene/theme.h"
#include "gl/renderer.h"
#include "tests/scene/scene_source.h"
#include "tests/support/ray_caster.h"

namespace vvr {
namespace {

const scene::TransferFunction solid({{0, {}, 0}, {1, {}, 0}, {40, {0, 0, 1}, 4000}});

constexpr Size field_size{48, 36};

/// Part of a field, and whose it is.
struct Owned {
    PixelBox box;
    std::size_t track;
};

void add(volume::Volume& volume, std::int64_t index, std::span<const Owned> things, std::uint8_t value = 255) {
    fields::Field field{index, static_cast<double>(index) / 25, Plane<std::uint8_t>(field_size), {}, {}};
    std::vector<fields::LabelRun> runs;
    for (const auto& [box, track] : things) {
        for (int j = box.top; j < box.bottom; ++j) {
            std::ranges::fill(
                field.scalar.row(j).subspan(static_cast<std::size_t>(box.left), static_cast<std::size_t>(box.width())),
                value);
            runs.push_back({j, box.left, box.right, track});
        }
    }
    volume.add(field, {}, runs);
}

/// Tracks 0 to 7 are the objects 1 to 8 with a colour each; all others are nobody's.
volume::VoxelStyle as_they_come(std::size_t track, const volume::Layer&) {
    if (track >= 8) return {};
    return {scene::palette_index(static_cast<int>(track), scene::ObjectState::moving),
            static_cast<std::uint16_t>(track + 1)};
}

class Objects : public testing::TestWithParam<std::string> {
  protected:
    Objects() {
        options_.size = {240, 180};
        options_.samples = 1;
        options_.slices = 400;
        options_.colour = gl::VolumeColour::object;
    }

    void draw(const volume::Volume& volume, const space::View& view, int bricks = 3) {
        options_.view = view;
        layout_ = space::make_layout(GetParam(), space::shape_for(field_size));
        gl::Renderer renderer(*context_, *layout_, options_);
        renderer.set_transfer(solid);
        renderer.set_palette(scene::object_palette(theme_));
        gl::BrickWindow window(context_->gl(), *layout_, volume.layers(), 2);
        const volume::VoxelStyleLookup identify = as_they_come;
        window.show(volume, volume::cut_into(volume.layers(), bricks), 0, identify);
        picture_ = renderer.draw(window);
        data_ = renderer.draw_pixel_data(window, scene::TimeTable(volume));
        camera_ = renderer.camera();
    }

    /// Which of the colours a pixel has: -1 = the background, -2 = another.
    int colour_at(int i, int j) const {
        const glm::vec3 pixel(picture_.at(i, j));
        const auto is = [&](const glm::vec3& colour) { return glm::distance(pixel, colour) < 0.02F; };
        if (is(glm::vec3(options_.background))) return -1;
        const auto found = std::ranges::find_if(theme_.objects, is);
        return found == theme_.objects.end() ? -2 : static_cast<int>(found - theme_.objects.begin());
    }

    scene::Theme theme_ = scene::themes().front();
    std::unique_ptr<gl::Context> context_ = gl::open_context("software");
    gl::RenderOptions options_;
    std::unique_ptr<space::Layout> layout_;
    space::Camera camera_;
    Plane<glm::vec4> picture_;
    image::PixelData data_;
};

TEST_P(Objects, ThatTouchHaveNoThirdColourBetweenThem) {
    volume::Volume volume(field_size, {.capacity = 60, .keep_owners = true});
    const std::array things{Owned{{8, 10, 24, 28}, 0}, Owned{{24, 10, 40, 28}, 3}};
    for (int i = 0; i < 60; ++i) add(volume, i, things);
    for (const space::View& view :
         {space::View{0, 0, 0, 0.04}, space::View{-60, 35, 30, 0.04}, space::View{40, 60, 0, 0.04}}) {
        draw(volume, view);
        std::map<int, int> seen;
        for (int j = 0; j < options_.size.height; ++j) {
            for (int i = 0; i < options_.size.width; ++i) {
                // Where a thing is only just grazed the background shines through.
                if (picture_.at(i, j).a < 0.99F || data_.object.at(i, j) == 0) continue;
                const int colour = colour_at(i, j);
                if (colour == -1) continue;
                ++seen[colour];
                EXPECT_TRUE(colour == -2 || colour == static_cast<int>(data_.object.at(i, j)) - 1);
            }
        }
        EXPECT_GT(seen[0] + seen[3], 1000);
        int mixed = 0;
        for (const auto& [colour, count] : seen) mixed += colour != 0 && colour != 3 ? count : 0;
        EXPECT_LT(mixed, (seen[0] + seen[3]) / 20) << "the edges against the background";
    }
}

TEST_P(Objects, AreWhereTheirVoxelsAre) {
    volume::Volume volume(field_size, {.capacity = 60, .keep_owners = true});
    const std::array things{Owned{{6, 6, 18, 18}, 1}, Owned{{18, 6, 30, 18}, 2}, Owned{{6, 18, 18, 30}, 4},
                            Owned{{30, 20, 42, 32}, 6}};
    for (int i = 0; i < 60; ++i) add(volume, i, things);
    draw(volume, {10, 40, 0, 0.04});
    std::set<float> seen;
    for (int j = 0; j < options_.size.height; ++j) {
        for (int i = 0; i < options_.size.width; ++i) {
            const float number = data_.object.at(i, j);
            if (number == 0) continue;
            seen.insert(number);
            const glm::dvec3 c =
                test::c_of_pixel(i, j, static_cast<double>(data_.depth.at(i, j)), camera_, *layout_, options_.size);
            const double column = (1 - c.x) * field_size.width - 0.5;
            const double row = (1 - c.y) * field_size.height - 0.5;
            const auto* const thing = std::ranges::find(things, static_cast<std::size_t>(number) - 1, &Owned::track);
            ASSERT_NE(thing, things.end()) << number;
            // Interpolation reaches a voxel beyond what is there, slices are a little apart.
            const double slack = 1.2;
            EXPECT_GT(column, thing->box.left - 0.5 - slack) << number;
            EXPECT_LT(column, thing->box.right - 0.5 + slack) << number;
            EXPECT_GT(row, thing->box.top - 0.5 - slack) << number;
            EXPECT_LT(row, thing->box.bottom - 0.5 + slack) << number;
        }
    }
    EXPECT_EQ(seen, (std::set<float>{2, 3, 5, 7}));
}

TEST_P(Objects, HaveNoFringeOfWhatIsNobodys) {
    volume::Volume volume(field_size, {.capacity = 40, .keep_owners = true});
    const std::array things{Owned{{16, 10, 32, 26}, 5}};
    for (int i = 0; i < 40; ++i)
        add(volume, i, i >= 10 && i < 30 ? std::span<const Owned>(things) : std::span<const Owned>{});
    draw(volume, {20, 30, 0, 0.04});
    int seen = 0;
    for (std::size_t i = 0; i < picture_.pixels().size(); ++i) {
        const glm::vec4& pixel = picture_.pixels()[i];
        const glm::vec3 away = glm::vec3(options_.background) - glm::vec3(pixel);
        const float part = glm::length(away) / glm::length(glm::vec3(options_.background) - theme_.objects[5]);
        if (part < 0.02F) continue;
        ++seen;
        // Between the background and the object's colour there is nothing else.
        EXPECT_LT(glm::distance(glm::vec3(pixel), glm::mix(glm::vec3(options_.background), theme_.objects[5], part)),
                  0.02F);
    }
    EXPECT_GT(seen, 500);
}

INSTANTIATE_TEST_SUITE_P(Layouts, Objects, testing::Values("horseshoe", "box"),
                         [](const auto& tested) { return tested.param; });

TEST(Owners, FollowTheFrameWhoseValueWon) {
    volume::Volume volume(field_size, {.capacity = 2, .step = 3, .keep_owners = true});
    const std::array first{Owned{{0, 0, 20, 20}, 70'000}};
    const std::array second{Owned{{10, 0, 30, 20}, 80'000}};
    const std::array third{Owned{{12, 0, 40, 20}, 90'000}};
    add(volume, 0, first, 100);
    add(volume, 1, second, 100);
    add(volume, 2, third, 200);
    const volume::Layer& layer = volume.layer(0);
    ASSERT_EQ(layer.frames, 3);
    const auto track_at = [&](int i, int j) { return volume.track_of(layer.owner.at(i, j)); };
    EXPECT_EQ(track_at(5, 5), 70'000U);
    EXPECT_EQ(track_at(11, 5), 70'000U) << "the earlier of two alike";
    EXPECT_EQ(track_at(12, 5), 90'000U);
    EXPECT_EQ(track_at(39, 19), 90'000U);
    EXPECT_EQ(layer.owner.at(41, 5), 0);
}

TEST(Owners, StayWithTheirValuesWhereLayersAreJoined) {
    volume::Volume volume(field_size, {.capacity = 2, .keep_owners = true});
    for (int i = 0; i < 4; ++i) {
        const std::array thing{Owned{{4 * i, 4, 4 * i + 8, 12}, static_cast<std::size_t>(i)}};
        add(volume, i, thing, static_cast<std::uint8_t>(100 + 10 * i));
    }
    ASSERT_EQ(volume.layers(), 2);
    for (int i = 0; i < 20; ++i) {
        for (const std::int64_t number : {0, 1}) {
            const volume::Layer& layer = volume.layer(number);
            const int value = layer.scalar.at(i, 8);
            ASSERT_EQ(layer.owner.at(i, 8) == 0, value == 0);
            if (value == 0) continue;
            EXPECT_EQ(volume.track_of(layer.owner.at(i, 8)), static_cast<std::size_t>((value - 100) / 10));
        }
    }
}

TEST(Owners, AreCountedAgainWhenAllNumbersAreTaken) {
    constexpr Size size{16, 16};
    volume::Volume volume(size, {.capacity = 4, .span = 4, .keep_owners = true});
    const auto show = [&](std::int64_t index, std::size_t first_track) {
        fields::Field field{index, static_cast<double>(index), Plane<std::uint8_t>(size, 255), {}, {}};
        std::vector<fields::LabelRun> runs;
        for (int j = 0; j < size.height; ++j) {
            for (int i = 0; i < size.width; ++i) runs.push_back({j, i, i + 1, first_track++});
        }
        volume.add(field, {}, runs);
        return first_track;
    };
    std::size_t next = 0;
    for (std::int64_t i = 0; i < 600; ++i) {
        if (volume.layers() == 4) volume.drop_front(1);
        const std::size_t first = next;
        next = show(i, first);
        const volume::Layer& newest = volume.layer(volume.layers() - 1);
        ASSERT_EQ(volume.track_of(newest.owner.at(0, 0)), first) << i;
        ASSERT_EQ(volume.track_of(newest.owner.at(15, 15)), next - 1) << i;
    }
    EXPECT_GT(next, 150'000U);
}

TEST(Owners, ReachToTheRimOfWhatIsTheirs) {
    volume::Volume volume(field_size, {.capacity = 4, .keep_owners = true});
    fields::Field field{0, 0, Plane<std::uint8_t>(field_size), {}, {}};
    for (int i = 0; i < 30; ++i) field.scalar.at(i, 10) = 90;
    const std::array runs{fields::LabelRun{10, 5, 9, 3}, fields::LabelRun{10, 11, 14, 4}};
    volume.add(field, {}, runs);
    const volume::Layer& layer = volume.layer(0);
    EXPECT_EQ(layer.owner.at(1, 10), 0);
    for (int i = 2; i < 10; ++i) EXPECT_EQ(volume.track_of(layer.owner.at(i, 10)), 3U) << i;
    for (int i = 10; i < 17; ++i) EXPECT_EQ(volume.track_of(layer.owner.at(i, 10)), 4U) << i;
    EXPECT_EQ(layer.owner.at(17, 10), 0);
    EXPECT_EQ(layer.owner.at(5, 9), 0) << "the field has nothing there";
}

tracking::FrameLabels labels_at(std::int64_t frame, std::initializer_list<std::size_t> tracks) {
    tracking::FrameLabels labels{{frame, static_cast<double>(frame) / 25}, {}};
    for (const std::size_t track : tracks) labels.runs.push_back({0, 0, 1, track});
    return labels;
}

volume::Layer layer_at(std::int64_t first, std::int64_t last) {
    volume::Layer layer;
    layer.first_frame = first;
    layer.last_frame = last;
    return layer;
}

TEST(LiveObjects, KeepWhatWasDecidedAndAreNobodysWhileTheyMayBeNothing) {
    app::LiveObjects live;
    const volume::VoxelStyleLookup identify = live.identify();
    for (int i = 0; i < 100; ++i) {
        if (i < 95) live.see(labels_at(i, {0}));
        if (i >= 95) live.see(labels_at(i, {0, 1}));
    }
    live.decide(0);
    const volume::VoxelStyle first = identify(0, layer_at(10, 10));
    EXPECT_NE(first.look, 0);
    EXPECT_EQ(identify(1, layer_at(97, 97)).look, 0) << "it has been there for a fifth of a second";
    for (int i = 100; i < 200; ++i) live.see(labels_at(i, {0, 1}));
    live.decide(0);
    EXPECT_EQ(identify(0, layer_at(10, 10)), first);
    EXPECT_EQ(identify(0, layer_at(150, 150)), first);
    EXPECT_EQ(identify(1, layer_at(97, 97)).look, 0) << "as in the picture before";
    EXPECT_NE(identify(1, layer_at(120, 120)).look, 0);
    EXPECT_NE(identify(1, layer_at(120, 120)).look, first.look);
}

TEST(LiveObjects, InSightAtOnceDiffer) {
    app::LiveObjects live;
    for (int i = 0; i < 60; ++i) live.see(labels_at(i, {0, 1, 2, 3, 4, 5, 6, 7}));
    live.decide(0);
    std::set<int> looks;
    for (std::size_t track = 0; track < 8; ++track) looks.insert(live.identify()(track, layer_at(20, 20)).look);
    EXPECT_EQ(looks.size(), 8U);
}

}  // namespace
}  // namespace vvr
