// The events of scenes of which it is known what happens.
#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/events/event_finder.h"
#include "core/fields/field_source.h"
#include "tests/scene/scene.h"
#include "tests/scene/scene_source.h"

namespace vvr {
namespace {

constexpr double frames_off = 5;
constexpr double pixels_off = 5;

std::vector<events::Event> events_of(const generator::Scene& scene) {
    video::SourceOptions source;
    source.colour = true;
    source.field_size = {-1, -1};
    fields::FieldOptions fields;
    fields.flow.method = "none";
    events::EventFinder finder(scene.size());
    const auto clip = generator::open_scene(scene, source);
    fields::compute_fields(
        *clip, fields,
        [&](const video::SharedFrame& frame, fields::Field&& field) {
            finder.add({field.scalar, frame->grey, frame->colour}, {field.index, field.pts});
        },
        [&](const fields::Reference& empty) { finder.set_scene(empty); });
    return finder.finish().events;
}

struct Visit {
    int first;
    int last;
};

/// When each object can be seen: enough of it to be told from nothing.
std::map<std::string, std::vector<Visit>> visits_of(const generator::Scene& scene) {
    constexpr int least = 30;  // pixels
    std::map<std::string, std::vector<Visit>> visits;
    for (int f = 0; f < scene.frames(); ++f) {
        for (const generator::Object& object : scene.truth(f).objects) {
            if (std::ranges::count(object.mask.pixels(), 255) < least) continue;
            std::vector<Visit>& own = visits[object.name];
            if (own.empty() || own.back().last < f - 1) own.push_back({f, f});
            own.back().last = f;
        }
    }
    return visits;
}

bool goes_right(const generator::Scene& scene, const std::string& name, int frame) {
    const generator::Truth truth = scene.truth(frame);
    const auto found = std::ranges::find(truth.objects, name, &generator::Object::name);
    return found != truth.objects.end() && found->vx > 0;
}

void expect_frames(const Moment& first, const Moment& last, double begin, double end) {
    EXPECT_NEAR(static_cast<double>(first.frame), begin, frames_off);
    EXPECT_NEAR(static_cast<double>(last.frame), end, frames_off);
}

struct Case {
    std::string name;
    int frames;
    std::uint64_t seed;
    double noise;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.name;
}

class LeftBagEvents : public testing::TestWithParam<Case> {};

TEST_P(LeftBagEvents, AreTwoVisitsAndTheBagBetweenThem) {
    generator::Options options;
    options.frames = GetParam().frames;
    options.seed = GetParam().seed;
    options.noise = GetParam().noise;
    const generator::Scene scene = generator::make_left_bag(options);
    const generator::LeftBag facts = generator::left_bag_facts(options);
    const std::vector<events::Event> events = events_of(scene);
    ASSERT_EQ(events.size(), 3U);

    const std::vector<Visit> visits = visits_of(scene)["person"];
    ASSERT_EQ(visits.size(), 2U);
    expect_frames(events[0].first, events[0].last, visits[0].first, visits[0].last);
    expect_frames(events[2].first, events[2].last, visits[1].first, visits[1].last);

    const events::Event& bag = events[1];
    expect_frames(bag.first, bag.last, facts.put_down, facts.taken_up - 1);
    ASSERT_EQ(bag.stays.size(), 1U);
    expect_frames(bag.stays[0].first, bag.stays[0].last, facts.put_down, facts.taken_up - 1);
    EXPECT_NEAR(bag.stays[0].place.x, facts.x, pixels_off);
    EXPECT_NEAR(bag.stays[0].place.y, facts.y, pixels_off);
    EXPECT_LT(bag.path_length, pixels_off);
    EXPECT_EQ(bag.from, 0U);
    EXPECT_EQ(bag.into, 2U);

    // He goes through the picture; his middle is that of what he carries as well.
    EXPECT_GT(events[0].path_length, 0.9 * scene.size().width);
    for (const events::PathPoint& point : events[0].path) {
        const generator::Truth truth = scene.truth(static_cast<int>(point.at.frame));
        const auto person = std::ranges::find(truth.objects, "person", &generator::Object::name);
        ASSERT_NE(person, truth.objects.end());
        if (person->x < 30 || person->x > scene.size().width - 30 || std::abs(person->x - facts.x) < 40) continue;
        EXPECT_NEAR(point.place.x, person->x, 10) << point.at.frame;
    }
}

INSTANTIATE_TEST_SUITE_P(Quick, LeftBagEvents,
                         testing::Values(Case{"as_it_is", 600, 1, 0}, Case{"with_noise", 600, 2, 5}),
                         [](const auto& test) { return test.param.name; });
INSTANTIATE_TEST_SUITE_P(Nightly, LeftBagEvents,
                         testing::Values(Case{"as_it_is", 1600, 1, 0}, Case{"another_hall", 1600, 3, 0},
                                         Case{"noise", 1600, 1, 5}),
                         [](const auto& test) { return test.param.name; });

TEST(StillEvents, NoiseIsNone) {
    for (const double noise : {0.0, 5.0, 8.0}) {
        generator::Options options;
        options.noise = noise;
        options.frames = 150;
        EXPECT_TRUE(events_of(generator::make_still(options)).empty()) << noise;
    }
}

TEST(FallOnFloorEvents, AreOneThatLiesStill) {
    const generator::Scene scene = generator::make_fall_on_floor({});
    const generator::FallOnFloor facts = generator::fall_on_floor_facts({});
    const std::vector<events::Event> events = events_of(scene);
    ASSERT_EQ(events.size(), 1U);
    const std::vector<Visit> visits = visits_of(scene)["person"];
    expect_frames(events[0].first, events[0].last, visits.front().first, visits.back().last);
    ASSERT_EQ(events[0].stays.size(), 1U);
    expect_frames(events[0].stays[0].first, events[0].stays[0].last, facts.lies, facts.gets_up);
    EXPECT_NEAR(events[0].stays[0].place.x, facts.x, pixels_off);
    EXPECT_NEAR(events[0].stays[0].place.y, facts.y, pixels_off);
}

TEST(TwoWalkersCrossEvents, AreTwoThatKeepTheirWays) {
    for (const double noise : {0.0, 5.0}) {
        generator::Options options;
        options.noise = noise;
        const generator::Scene scene = generator::make_two_walkers_cross(options);
        const std::vector<events::Event> events = events_of(scene);
        ASSERT_EQ(events.size(), 2U) << noise;
        const auto visits = visits_of(scene);
        for (const std::string name : {"walker 0", "walker 1"}) {
            const std::vector<Visit>& own = visits.at(name);
            const bool rightward = goes_right(scene, name, own.front().first + 20);
            const auto event = std::ranges::find_if(events, [&](const events::Event& e) {
                return (e.path.back().place.x > e.path.front().place.x) == rightward;
            });
            ASSERT_NE(event, events.end()) << name;
            expect_frames(event->first, event->last, own.front().first, own.back().last);
            EXPECT_GT(event->path_length, 0.9 * scene.size().width);
        }
    }
}

TEST(WalkersEvents, AreAsManyAsWalkers) {
    const generator::Scene scene = generator::make_walkers({});
    const std::vector<events::Event> events = events_of(scene);
    ASSERT_EQ(events.size(), 6U);
    const auto visits = visits_of(scene);
    for (int k = 0; k < 6; ++k) {
        const Visit visit = visits.at("walker " + std::to_string(k)).front();
        // One of them comes in behind another, so his beginning is not so well known.
        const bool there = std::ranges::any_of(events, [&](const events::Event& event) {
            return std::abs(event.first.frame - visit.first) <= 12 && std::abs(event.last.frame - visit.last) <= 5;
        });
        EXPECT_TRUE(there) << "walker " << k << ": " << visit.first << " to " << visit.last;
    }
}

}  // namespace
}  // namespace vvr
