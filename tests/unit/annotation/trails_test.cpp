#include <gtest/gtest.h>

#include "core/annotation/objects.h"
#include "core/annotation/scene_map.h"

namespace vvr {
namespace {

constexpr Size field{64, 48};
constexpr int frames = 100;

/// 100 frames.
volume::Volume empty_volume(double rate = 10) {
    volume::Volume volume(field, {frames});
    for (int i = 0; i < frames; ++i) {
        volume.add({i, i / rate, Plane<std::uint8_t>(field), {}, {}}, {});
    }
    return volume;
}

/// Goes from the left to the right in the first half, then stands.
tracking::Event walker() {
    tracking::Event event;
    event.first = {0, 0};
    event.last = {99, 9.9};
    for (int i = 0; i < frames; i += 5) event.path.push_back({{i, i / 10.0}, {std::min(2 + 1.2 * i, 60.0), 24}});
    event.path.push_back({{99, 9.9}, {60, 24}});
    return event;
}

/// A camera that shows the whole layout in a part of the picture.
space::Camera camera_on(const space::Layout& layout, const PixelBox& part, Size picture) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= 16; ++i) {
        for (const double x : {0.0, 1.0}) points.push_back(layout.p_from_c({x, x, i / 16.0}));
    }
    return space::fit_camera({}, points, part.size()).within(part, picture);
}

TEST(Trails, AreWhereTheVolumeShowsTheObject) {
    const volume::Volume volume = empty_volume();
    const auto layout = space::make_layout("horseshoe", space::shape_for(field));
    const space::Camera camera;
    const annotation::Trails trails(volume, *layout, camera, {100, 100});
    const glm::dvec3 expected = layout->p_from_c(volume.c_of({2, 24, 0}));
    const glm::dvec3 found = trails.point(walker(), 0);
    EXPECT_LT(glm::distance(expected, found), 0.05);
}

TEST(Directions, LeadAlongThePathAndNotWhereItStands) {
    const volume::Volume volume = empty_volume();
    const auto layout = space::make_layout("box", space::shape_for(field));
    annotation::Objects objects;
    objects.events = {walker()};
    const std::vector<scene::Glyph> arrows = annotation::direction_arrows(objects, volume, *layout, 0.1);
    ASSERT_FALSE(arrows.empty());
    for (const scene::Glyph& arrow : arrows) {
        EXPECT_NEAR(glm::length(arrow.vector), 0.1, 1e-6);
        EXPECT_LT(arrow.frame, 55);
        const glm::dvec3 from = layout->c_from_p(glm::dvec3(arrow.from));
        const glm::dvec3 to = layout->c_from_p(glm::dvec3(arrow.from + arrow.vector));
        EXPECT_GT(to.z, from.z);  // later
        EXPECT_LT(to.x, from.x);  // to the right in the frame: x_C runs against the columns
    }
}

TEST(Directions, OfWhatNobodySawAreNone) {
    const volume::Volume volume = empty_volume();
    const auto layout = space::make_layout("box", space::shape_for(field));
    tracking::Event hidden = walker();
    hidden.path = {hidden.path.front(), hidden.path.back()};
    annotation::Objects objects;
    objects.events = {hidden};
    EXPECT_TRUE(annotation::direction_arrows(objects, volume, *layout, 0.1).empty());
}

// On the mark of another moment, a time would be read as that moment's.
TEST(Stays, HaveTheirTimesBesideTheirOwnMarks) {
    const volume::Volume volume = empty_volume(2.5);
    const auto layout = space::make_layout("horseshoe", space::shape_for(field));
    const annotation::Sheet sheet = annotation::arrange_sheet({640, 400}, {.ruler = true});
    const space::Camera camera = camera_on(*layout, sheet.between, sheet.picture);
    const annotation::Trails trails(volume, *layout, camera, sheet.picture);
    std::size_t labelled = 0;
    for (int begin = 0; begin < 37; ++begin) {
        for (const double row : {6.0, 16.0, 24.0, 40.0}) {
            annotation::Objects objects;
            tracking::Event event = walker();
            event.path = {{{0, 0}, {32, row}}, {{99, 39.6}, {32, row}}};
            event.last = {99, 39.6};
            event.stays = {{{0, 1.0 * begin}, {0, begin + 2.1}, {32, row}, {}}};
            objects.events = {event};
            objects.numbers = {1};
            objects.colours = {{0, 0, 1}};
            annotation::Lettering lettering;
            annotation::label_stays(objects, trails, sheet, {1, 1, 1, 1}, lettering);
            ASSERT_EQ(lettering.strokes.size(), 4U);
            labelled += lettering.labels.size();
            for (const annotation::Label& label : lettering.labels) {
                for (const annotation::Stroke& mark : lettering.strokes) {
                    const glm::ivec2 low(glm::min(mark.from, mark.to));
                    const glm::ivec2 high(glm::max(mark.from, mark.to));
                    EXPECT_FALSE(label.box.intersects({low.x, low.y, high.x + 1, high.y + 1}))
                        << begin << " s, row " << row;
                }
            }
        }
    }
    EXPECT_GT(labelled, 200U) << "of 296";
}

TEST(Hollow, HoldsAFrameInTheOpenMiddle) {
    const auto layout = space::make_layout("horseshoe", space::shape_for(field));
    const Size picture{1280, 800};
    const PixelBox part{100, 230, 1180, 620};
    const space::Camera camera = camera_on(*layout, part, picture);
    const PixelBox area{200, 0, 1080, 660};
    const PixelBox hollow = annotation::map_box(*layout, camera, picture, area, 4.0 / 3);
    EXPECT_GT(hollow.width(), 120);
    EXPECT_NEAR(hollow.width() * 3.0 / 4, hollow.height(), 1);
    EXPECT_TRUE(area.contains(hollow));
    // No corner of a cut through the volume lies in it.
    for (int i = 0; i <= 64; ++i) {
        for (const double x : {0.0, 1.0}) {
            for (const double y : {0.0, 1.0}) {
                const glm::dvec2 at = camera.pixel(layout->p_from_c({x, y, i / 64.0}), picture);
                EXPECT_FALSE(at.x > hollow.left && at.x < hollow.right && at.y > hollow.top && at.y < hollow.bottom);
            }
        }
    }
    EXPECT_TRUE(annotation::map_box(*layout, camera, picture, {}, 4.0 / 3).empty());
}

}  // namespace
}  // namespace vvr
