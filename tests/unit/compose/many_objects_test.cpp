// Portraits, map, strip and text of random events: each has its place.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cli/compose/compose.h"
#include "cli/plan/make_plan.h"
#include "tests/support/fields.h"

namespace vvr {
namespace {

/// Events at random places and times, as many as a busy day has.
std::vector<tracking::Event> random_events(int count, double seconds, Size field, std::mt19937& random) {
    const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    std::vector<tracking::Event> events;
    for (int k = 0; k < count; ++k) {
        tracking::Event event;
        event.kind = static_cast<tracking::EventKind>(k % 4);
        const double first = any(0, 0.9 * seconds);
        const double last = any(first + 0.05 * seconds, seconds);
        event.first = {static_cast<std::int64_t>(first * 25), first};
        event.last = {static_cast<std::int64_t>(last * 25), last};
        for (int i = 0; i <= 8; ++i) {
            const double at = std::lerp(first, last, i / 8.0);
            event.path.push_back(
                {{static_cast<std::int64_t>(at * 25), at}, {any(0, field.width), any(0, field.height)}});
        }
        if (k % 4 != 0) event.stays.push_back({event.first, event.last, event.path.front().place, {}});
        event.tracks = {static_cast<std::size_t>(k)};
        events.push_back(event);
    }
    std::ranges::sort(events, {}, [](const tracking::Event& event) { return event.first.seconds; });
    return events;
}

class OfManyObjects : public testing::TestWithParam<std::tuple<Size, int>> {};

// Whatever the events: nothing overlaps, nothing leaves the picture, and no text is smaller than can be read.
TEST_P(OfManyObjects, EachPartHasItsPlace) {
    const auto& [size, count] = GetParam();
    std::mt19937 random(static_cast<unsigned>(count));
    const volume::Volume volume = test::even_volume({32, 24}, 250);
    app::RenderJob job;
    job.picture.size = size;
    const std::vector<tracking::Event> events = random_events(count, 9.9, volume.size(), random);
    const Plane<Bgr> picture_of_scene(volume.size());
    const auto frame_at = [&](std::int64_t index, double seconds) {
        return std::make_shared<const media::Frame>(
            media::Frame{index, seconds, Plane<std::uint8_t>(volume.size()), picture_of_scene});
    };
    app::Observation seen{volume};
    seen.scene = picture_of_scene;
    seen.first = frame_at(0, 0);
    seen.last = frame_at(249, 9.9);
    for (std::size_t k = 0; k < events.size(); ++k)
        seen.crops.keep(k, {events[k].first, {2, 2, 12, 12}, 1}, *seen.first);
    seen.events = app::events_between(events, 0, 9.9);
    const app::Plan plan = app::make_plan(job, {.field_size = volume.size()});
    const app::Composition composed = app::compose(plan, seen);
    const annotation::Lettering& lettering = composed.lettering;

    const PixelBox picture{0, 0, size.width, size.height};
    const int readable = size.width >= 1280 ? 11 : 9;
    std::vector<std::pair<PixelBox, std::string>> parts;
    for (const annotation::PastedPicture& pasted : lettering.pictures) {
        parts.emplace_back(pasted.box.inflated(pasted.border, pasted.border), "a picture");
    }
    for (const annotation::Label& label : lettering.labels) {
        parts.emplace_back(label.box, label.text);
        EXPECT_GE(label.size, readable) << label.text;
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        EXPECT_TRUE(picture.contains(parts[i].first)) << parts[i].second;
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_FALSE(parts[i].first.intersects(parts[j].first)) << parts[i].second << " " << parts[j].second;
        }
    }
    for (const annotation::Badge& badge : lettering.badges) {
        EXPECT_TRUE(picture.contains(badge.box)) << badge.label.text;
        EXPECT_GE(badge.label.size, readable) << badge.label.text;
    }
    // Each number that the picture shows is on the map or beside a bar.
    for (const annotation::Badge& shown : lettering.badges) {
        const auto is_on_map = [&](const annotation::Badge& badge) {
            return badge.label.text == shown.label.text &&
                   std::ranges::any_of(lettering.pictures, [&](const annotation::PastedPicture& pasted) {
                       return pasted.border == 0 && pasted.box.contains(badge.box);
                   });
        };
        const auto is_beside_bar = [&](const annotation::Label& label) { return label.text == shown.label.text; };
        EXPECT_TRUE(std::ranges::any_of(lettering.badges, is_on_map) ||
                    std::ranges::any_of(lettering.labels, is_beside_bar))
            << shown.label.text;
    }
    if (size.width >= 640) {
        EXPECT_GE(static_cast<int>(lettering.pictures.size()), 3 + std::min(count, 2)) << "map, ends, portraits";
    }
}

INSTANTIATE_TEST_SUITE_P(Pictures, OfManyObjects,
                         testing::Combine(testing::Values(Size{640, 480}, Size{1280, 800}, Size{3840, 2160},
                                                          Size{800, 1280}, Size{320, 240}),
                                          testing::Values(0, 1, 7, 40, 200)));

}  // namespace
}  // namespace vvr
