// What the finder makes of fields that are painted by hand.
#include "core/tracking/event_finder.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/planes.h"
#include "tests/unit/tracking/found.h"

namespace vvr {
namespace {

using test::at;

using Paint = std::function<void(int, Plane<std::uint8_t>&)>;

/// A finder for fields without pictures, where what is no object is black.
tracking::EventFinder finder_on_black() {
    tracking::EventFinder finder({120, 90}, {.scene_is_learnt = false});
    finder.set_scenes({{Plane<std::uint8_t>({120, 90}), {}}});
    return finder;
}

/// \param gap so many frames are missing after the first 200
std::vector<tracking::Event> events_of(int frames, const Paint& paint, int gap = 0) {
    tracking::EventFinder finder = finder_on_black();
    for (int f = 0; f < frames; ++f) {
        Plane<std::uint8_t> field({120, 90});
        paint(f, field);
        finder.add({field, {}, {}}, at(f < 200 ? f : f + gap));
    }
    return finder.finish().events;
}

TEST(EventFinder, NothingIsNoEventAndABlinkIsNone) {
    EXPECT_TRUE(events_of(50, [](int, auto&) {}).empty());
    EXPECT_TRUE(events_of(50, [](int f, auto& field) {
                    if (f > 20 && f < 30) fill(field, {20, 20, 40, 40}, 100);
                }).empty());
}

TEST(EventFinder, WhatFluttersAtItsPlaceIsNone) {
    EXPECT_TRUE(events_of(300, [](int f, auto& field) {
                    const int x = 40 + static_cast<int>(4 * std::sin(0.5 * f));
                    fill(field, {x, 30, x + 16, 40}, static_cast<std::uint8_t>(60 + (37 * f) % 150));
                }).empty());
}

// The box stands where the one who brought it was, and is told from him only when he has gone.
TEST(EventFinder, ABoxBeginsWhenItIsPutDownAndEndsWhenItIsTaken) {
    const auto person = [](auto& field, int x) { fill(field, {x, 30, x + 14, 70}, 120); };
    const auto events = events_of(500, [&](int f, auto& field) {
        if (f >= 100 && f < 400) fill(field, {60, 60, 72, 70}, 220);
        if (f < 90) person(field, f - 30);
        if (f >= 90 && f < 130) person(field, 60 - (f > 110 ? f - 110 : 0));
        if (f >= 130 && f < 200) person(field, 40 - (f - 130));
        if (f >= 340 && f < 390) person(field, 120 - (f - 340));
        if (f >= 390 && f < 410) person(field, 70);
        if (f >= 410) person(field, 70 - (f - 410));
    });
    ASSERT_EQ(events.size(), 3U);
    const tracking::Event& box = events[1];
    EXPECT_NEAR(static_cast<double>(box.first.frame), 120, 5) << "it comes to light from frame 113 to 124";
    EXPECT_NEAR(static_cast<double>(box.last.frame), 399, 5);
    ASSERT_EQ(box.stays.size(), 1U);
    EXPECT_EQ(box.stays[0].first.frame, box.first.frame);
    EXPECT_EQ(box.stays[0].last.frame, box.last.frame);
    EXPECT_NEAR(box.stays[0].place.x, 65.5, 2);
    EXPECT_NEAR(box.stays[0].place.y, 64.5, 2);
    EXPECT_EQ(box.from, 0U);
    EXPECT_EQ(box.into, 2U);
    EXPECT_TRUE(events[0].stays.empty());
}

TEST(EventFinder, WhoStoodThereFromTheFirstFrameMayLeaveAThing) {
    const auto events = events_of(400, [](int f, auto& field) {
        const int x = 60 - std::max(0, f - 100);
        fill(field, {60, 60, 72, 70}, 220);
        fill(field, {x, 30, x + 14, 72}, 120);
    });
    ASSERT_EQ(events.size(), 2U);
    EXPECT_TRUE(row_of(events[1].kind).is_thing);
    EXPECT_EQ(events[1].from, 0U);
    EXPECT_NEAR(static_cast<double>(events[1].first.frame), 110, 10);
}

/// A large person comes from the left, stands at the lower border, puts down a bag in frame 140, and leaves to the
/// right in a few frames: from frame 179 on, they are out of the picture.
void paint_bag_and_bearer(int frame, const PixelBox& bag, Plane<std::uint8_t>& field) {
    const int x = frame < 104 ? frame - 40 : frame < 160 ? 64 : 64 + 3 * (frame - 160);
    if (x < 120) fill(field, {x, 8, x + 40, 90}, 120);
    if (frame >= 140) fill(field, bag, 220);
}

/// \param more what else each field shows
std::vector<tracking::Event> events_of_bag(const PixelBox& bag, const Paint& more) {
    return events_of(430, [&](int f, auto& field) {
        paint_bag_and_bearer(f, bag, field);
        more(f, field);
    });
}

TEST(EventFinder, WhoLeavesThePictureIsNotTheThingThatStays) {
    const auto events = events_of_bag({88, 66, 108, 80}, [](int, auto&) {});
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[0].kind, tracking::EventKind::stood);
    EXPECT_NEAR(static_cast<double>(events[0].last.frame), 178, 4);
    ASSERT_EQ(events[0].stays.size(), 1U);
    EXPECT_EQ(events[1].kind, tracking::EventKind::left);
    EXPECT_NEAR(static_cast<double>(events[1].first.frame), 140, 4);
    EXPECT_EQ(events[1].by, 0U) << "it goes elsewhere, though its last place is beside the thing";
}

// Where the empty scene has an outline too, half as strong, nobody knows whether the bag came or something else went.
TEST(EventFinder, APlaceWithAnOutlineBeforeAndAfterWasChanged) {
    Plane<std::uint8_t> scene({120, 90});
    fill(scene, {88, 66, 108, 80}, 150);
    tracking::EventFinder finder({120, 90}, {.scene_is_learnt = false});
    finder.set_scenes({{scene, {}}});
    for (int f = 0; f < 430; ++f) {
        Plane<std::uint8_t> field({120, 90});
        paint_bag_and_bearer(f, {88, 66, 108, 80}, field);
        finder.add({field, {}, {}}, at(f));
    }
    const auto events = finder.finish().events;
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[1].kind, tracking::EventKind::changed);
    EXPECT_EQ(events[1].by, 0U);
    ASSERT_EQ(events[1].stays.size(), 1U);
    EXPECT_NEAR(events[1].stays[0].place.x, 97.5, 2);
    ASSERT_TRUE(events[1].evidence);
    EXPECT_LT(events[1].evidence->confidence, 0.5);
}

// Both are still within two seconds of each other, and near: but he came from there.
TEST(EventFinder, WhoWalksAwayFromAPlaceAndLiesDownIsNotAPartOfIt) {
    const PixelBox place{98, 40, 112, 70};
    const auto events = events_of(500, [&](int f, auto& field) {
        const int x = f < 45 ? 2 * f : f < 70 ? 90 : f < 105 ? 90 - 2 * (f - 70) : 5;
        if (f >= 50) fill(field, place, 200);
        fill(field, f < 105 ? PixelBox{x, 32, x + 14, 74} : PixelBox{x, 60, x + 60, 74}, 120);
    });
    const auto man = std::ranges::find_if(events, [](const auto& event) { return !row_of(event.kind).is_thing; });
    ASSERT_NE(man, events.end());
    ASSERT_FALSE(man->stays.empty());
    EXPECT_FALSE(man->stays.back().box.intersects(place));
}

// The first blob of the bag's track has a part of the person, which takes its centre far away.
TEST(EventFinder, ABagDoesNotMoveBecausePartsOfItsBearerDo) {
    const auto events = events_of_bag({70, 70, 80, 78}, [](int f, auto& field) {
        if (f >= 171 && f < 174) fill(field, {70, 40, 100, 70}, 120);
    });
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[1].kind, tracking::EventKind::left);
    ASSERT_TRUE(events[1].evidence);
    EXPECT_LT(events[1].evidence->moved, 0.1);
}

// Nobody knows whether it moves while something covers it, until it is seen again as before.
TEST(EventFinder, ABagThatWasHiddenForAnInstantIsTheSameBag) {
    const auto events = events_of_bag({70, 66, 84, 78}, [](int f, auto& field) {
        if (f >= 360 && f < 368) fill(field, {50, 50, 104, 90}, 60);
    });
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[1].kind, tracking::EventKind::left);
    EXPECT_NEAR(static_cast<double>(events[1].first.frame), 140, 4);
    EXPECT_EQ(events[1].last.frame, 429);
    ASSERT_TRUE(events[1].evidence);
    EXPECT_NEAR(events[1].evidence->alone, (360 - 180) / 25.0, 0.5);
}

// A shadow that counted as a part of it goes: nobody is near all the same.
TEST(EventFinder, ABagIsAloneThoughAPartOfItIsSeenNoMore) {
    const auto events = events_of_bag({80, 66, 100, 80}, [](int f, auto& field) {
        if (f >= 140 && f < 230) fill(field, {100, 66, 108, 80}, 160);
    });
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[1].kind, tracking::EventKind::left);
    ASSERT_TRUE(events[1].evidence);
    EXPECT_GT(events[1].evidence->alone, (430 - 230) / 25.0);
}

TEST(EventFinder, TwoThatMeetAndPartStayTwo) {
    const auto events = events_of(200, [](int f, auto& field) {
        fill(field, {110 - f, 34, 122 - f, 74}, 210);
        fill(field, {f - 30, 30, f - 18, 70}, 90);
    });
    ASSERT_EQ(events.size(), 2U);
    for (const tracking::Event& event : events) {
        EXPECT_GT(event.path_length, 90);
        EXPECT_LT(std::abs(event.path.back().place.y - event.path.front().place.y), 8);
        EXPECT_GT(std::abs(event.path.back().place.x - event.path.front().place.x), 90) << "it turned back";
    }
}

TEST(EventFinder, NothingStandsWhileThereIsNoSignal) {
    const auto box = [](int, auto& field) { fill(field, {60, 60, 72, 70}, 220); };
    constexpr int hours = 25 * 3600 * 7;
    for (const int gap : {25, 600, hours}) {
        const auto events = events_of(400, box, gap);
        ASSERT_EQ(events.size(), 2U) << gap;
        EXPECT_EQ(events[0].last.frame, 199);
        EXPECT_EQ(events[1].first.frame, 200 + gap) << "what is there after the gap is seen from then on";
        EXPECT_EQ(events[1].last.frame, 399 + gap);
        EXPECT_NEAR(tracking::stationary_seconds(events[0]) + tracking::stationary_seconds(events[1]), 16, 0.1);
        for (const tracking::Event& event : events) {
            for (const tracking::PathPoint& point : event.path) {
                EXPECT_TRUE(point.at.frame < 200 || point.at.frame >= 200 + gap);
            }
        }
    }
    EXPECT_EQ(events_of(400, box).size(), 1U);
}

TEST(EventFinder, NobodyWalksThroughTimeWithoutSignal) {
    // Whoever is there after the gap goes on where the other was.
    const auto walker = [](int f, auto& field) { fill(field, {f / 3 - 10, 30, f / 3, 50}, 120); };
    const auto events = events_of(400, walker, 75);
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[0].last.frame, 199);
    EXPECT_EQ(events[1].first.frame, 275);
    EXPECT_FALSE(events[0].into || events[1].from);
    EXPECT_EQ(events_of(400, walker).size(), 1U);
}

/// What is found in 400 frames of a scene, in the middle of which 1000 are missing.
std::vector<tracking::Event> events_in(
    const fields::Planes& scene,
    const std::function<void(int, Plane<std::uint8_t>& field, Plane<std::uint8_t>& picture)>& paint) {
    tracking::EventFinder finder({120, 90});
    finder.set_scenes({scene});
    for (int f = 0; f < 400; ++f) {
        Plane<std::uint8_t> field({120, 90});
        Plane<std::uint8_t> picture = scene.grey;
        paint(f, field, picture);
        finder.add({field, picture, {}}, at(f < 200 ? f : f + 1000));
    }
    return finder.finish().events;
}

// The empty scene was made of frames with a box in it; fields show its ghost where it is not there.
TEST(EventFinder, WhatCameOrWentInAGapNobodyTells) {
    const Plane<std::uint8_t> floor({120, 90}, 90);
    fields::Planes scene{floor, {}};
    fill(scene.grey, {60, 60, 72, 70}, 220);
    const auto events_of_ghost = [&](int from, int to) {
        return events_in(scene, [&](int f, auto& field, auto& picture) {
            const bool ghost = f >= from && f < to;
            if (ghost) fill(field, {60, 60, 72, 70}, 130);
            if (ghost) picture = floor;
            // Nothing is put down by nobody.
            if (to < 400) {
                fill(field, {f - to + 60, 15, f - to + 72, 55}, 100);
                fill(picture, {f - to + 60, 15, f - to + 72, 55}, 30);
            }
        });
    };
    EXPECT_TRUE(events_of_ghost(200, 400).empty()) << "it may be another light, or a camera that was turned";
    // It came while somebody could see it, in the second file: the ghost had been there before the gap, too.
    const auto came = events_of_ghost(0, 300);
    ASSERT_EQ(came.size(), 2U);
    EXPECT_EQ(came[1].kind, tracking::EventKind::left);
    EXPECT_NEAR(static_cast<double>(came[1].first.frame), 1300, 5);
    EXPECT_EQ(came[1].last.frame, 1399);
    // It came in the first file: that it lay there in the second nobody has followed.
    const auto early = events_of_ghost(0, 100);
    ASSERT_EQ(early.size(), 2U);
    EXPECT_EQ(early[1].kind, tracking::EventKind::left);
    EXPECT_EQ(early[1].last.frame, 199);
}

// The empty scene has a box that was put down after the beginning and fetched before the end.
TEST(EventFinder, WhatTheSceneHasIsGoneWhenItsPlaceIsEmptyAgain) {
    const Plane<std::uint8_t> floor({120, 90}, 90);
    fields::Planes scene{floor, {}};
    fill(scene.grey, {60, 60, 72, 70}, 220);
    tracking::EventFinder finder({120, 90});
    finder.set_scenes({scene});
    for (int f = 0; f < 600; ++f) {
        Plane<std::uint8_t> field({120, 90});
        Plane<std::uint8_t> picture = scene.grey;
        const bool ghost = f < 150 || f >= 450;
        if (ghost) fill(field, {60, 60, 72, 70}, 130);
        if (ghost) picture = floor;
        for (const int passes : {150, 450}) {
            fill(field, {f - passes + 60, 15, f - passes + 72, 55}, 100);
            fill(picture, {f - passes + 60, 15, f - passes + 72, 55}, 30);
        }
        finder.add({field, picture, {}}, at(f));
    }
    std::vector<tracking::Event> things = finder.finish().events;
    std::erase_if(things, [](const tracking::Event& event) { return !tracking::row_of(event.kind).is_thing; });
    ASSERT_EQ(things.size(), 2U);
    EXPECT_EQ(things[0].kind, tracking::EventKind::left);
    EXPECT_NEAR(static_cast<double>(things[0].first.frame), 150, 5);
    EXPECT_NEAR(static_cast<double>(things[0].last.frame), 450, 5) << "not to the end";
    EXPECT_EQ(things[1].kind, tracking::EventKind::taken);
    EXPECT_NEAR(static_cast<double>(things[1].first.frame), 450, 5);
}

TEST(EventFinder, KnowsTheLargestChangeSinceATime) {
    tracking::EventFinder finder({120, 90});
    for (int f = 0; f < 100; ++f) {
        Plane<std::uint8_t> field({120, 90});
        fill(field, {0, 0, f < 25 ? 120 : 12, 9}, 100);
        finder.add({field, field, {}}, at(f));
    }
    EXPECT_NEAR(finder.largest_share_since(0), 0.1, 1e-9);
    EXPECT_NEAR(finder.largest_share_since(2), 0.01, 1e-9);
    finder.forget_ended_before(1.5, {});
    EXPECT_NEAR(finder.largest_share_since(0), 0.01, 1e-9);
}

/// What is found in 400 frames of a camera that changes to infrared in the middle.
std::vector<tracking::Event> events_at_dusk(
    const fields::Planes& infrared,
    const std::function<void(int, Plane<std::uint8_t>& field, Plane<std::uint8_t>& picture)>& paint) {
    const fields::Planes day{Plane<std::uint8_t>({120, 90}, 90), {}};
    tracking::EventFinder finder({120, 90});
    finder.set_scenes({day, infrared});
    for (int f = 0; f < 400; ++f) {
        const bool dark = f >= 200;
        Plane<std::uint8_t> field({120, 90});
        Plane<std::uint8_t> picture = dark ? infrared.grey : day.grey;
        paint(f, field, picture);
        finder.add({field, picture, {}, dark}, at(f));
    }
    return finder.finish().events;
}

/// Somebody who goes to the right, with the left side at `left`.
void paint_walker(int left, Plane<std::uint8_t>& field, Plane<std::uint8_t>& picture) {
    fill(field, {left, 15, left + 12, 55}, 100);
    fill(picture, {left, 15, left + 12, 55}, 200);
}

TEST(Infrared, EndsWhatIsFollowed) {
    const fields::Planes infrared{Plane<std::uint8_t>({120, 90}, 30), {}};
    const auto events = events_at_dusk(infrared, [](int f, auto& field, auto& picture) {
        fill(field, {f / 3 - 10, 30, f / 3, 50}, 100);
        fill(picture, {f / 3 - 10, 30, f / 3, 50}, 200);
    });
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[0].last.frame, 199);
    EXPECT_EQ(events[0].view, 0U);
    EXPECT_EQ(events[1].first.frame, 200);
    EXPECT_EQ(events[1].view, 1U);
}

TEST(Infrared, HasItsOwnEmptyScene) {
    const fields::Planes infrared{Plane<std::uint8_t>({120, 90}, 30), {}};
    const auto events = events_at_dusk(infrared, [](int f, auto& field, auto& picture) {
        if (f >= 260) fill(field, {60, 60, 72, 70}, 120);
        if (f >= 260) fill(picture, {60, 60, 72, 70}, 90);  // as bright as the floor at day
        paint_walker(2 * (f - 230), field, picture);
    });
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[1].kind, tracking::EventKind::left);
    EXPECT_NEAR(static_cast<double>(events[1].first.frame), 260, 5);
}

TEST(Infrared, AGhostAtTheChangeIsAThingPutDownLater) {
    // It is in the scene, as it was put down early in the night; until then the fields show its ghost.
    fields::Planes infrared{Plane<std::uint8_t>({120, 90}, 30), {}};
    fill(infrared.grey, {60, 60, 72, 70}, 220);
    const auto events = events_at_dusk(infrared, [](int f, auto& field, auto& picture) {
        const bool ghost = f >= 200 && f < 260;
        if (ghost) fill(field, {60, 60, 72, 70}, 130);
        if (ghost) fill(picture, {60, 60, 72, 70}, 30);
        paint_walker(2 * (f - 230), field, picture);
    });
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[1].kind, tracking::EventKind::left);
    EXPECT_TRUE(events[1].in_scene);
    EXPECT_NEAR(static_cast<double>(events[1].first.frame), 260, 5);
    EXPECT_EQ(events[1].last.frame, 399);
}

TEST(EventFinder, WhatAllOfTheClipShowsIsLight) {
    const fields::Planes scene{Plane<std::uint8_t>({120, 90}, 90), {}};
    const auto events_of_patch = [&](int to) {
        return events_in(scene, [&](int f, auto& field, auto& picture) {
            if (f >= to) return;
            fill(field, {60, 60, 72, 70}, 130);
            fill(picture, {60, 60, 72, 70}, 220);
        });
    };
    EXPECT_TRUE(events_of_patch(400).empty()) << "on both sides of the gap, all the time";
    ASSERT_EQ(events_of_patch(200).size(), 1U);
    EXPECT_EQ(events_of_patch(200)[0].last.frame, 199);
}

TEST(EventFinder, ASlowRateIsNoGap) {
    tracking::EventFinder finder = finder_on_black();
    for (int f = 0; f < 40; ++f) {
        Plane<std::uint8_t> field({120, 90});
        if (f >= 5) fill(field, {60, 60, 72, 70}, 220);
        finder.add({field, {}, {}}, {f, 5.0 * f});
    }
    const tracking::Findings found = finder.finish();
    EXPECT_TRUE(found.events.empty()) << "nobody was seen to bring it";
    EXPECT_EQ(found.changes.size(), 1U);
}

TEST(EventFinder, EventsDoNotLeaveTheField) {
    const auto events = events_of(200, [](int f, auto& field) {
        fill(field, {f - 30, -10, f - 10, 30}, 90);
        fill(field, {60, 10, 70, 30}, 200);
    });
    ASSERT_FALSE(events.empty());
    for (const tracking::Event& event : events) {
        EXPECT_TRUE((PixelBox{0, 0, 120, 90}).contains(event.box));
    }
}

TEST(EventFinder, TellsSinceWhenSomethingMovesThatMayBeAnEvent) {
    tracking::EventFinder finder = finder_on_black();
    for (int f = 0; f < 300; ++f) {
        Plane<std::uint8_t> field({120, 90});
        // Something too short to be an event, and from frame 100 to 200 somebody who passes.
        if (f >= 30 && f < 50) fill(field, {60, 4, 72, 10}, 90);
        if (f >= 100 && f < 200) fill(field, {f - 90, 40, f - 76, 80}, 120);
        const std::optional<double> since = finder.add({field, {}, {}}, at(f)).busy_since;
        if (f < 120 || f > 226) {
            EXPECT_FALSE(since) << f;
        }
        if (f > 170 && f < 200) {
            EXPECT_EQ(since, at(100).seconds) << f;
        }
    }
}

TEST(EventFinder, WhoIsLostJustBeforeTheEndIsStillThere) {
    const auto still_there = [](int lost, int shift) {
        const std::vector<tracking::Event> found = events_of(100, [&](int f, auto& field) {
            if (f < lost) fill(field, {f + shift, 30, f + shift + 14, 70}, 120);
        });
        EXPECT_EQ(found.size(), 1U) << lost << ", " << shift;
        return found.size() == 1 && found.front().open_ended;
    };
    EXPECT_TRUE(still_there(100, 0));
    EXPECT_TRUE(still_there(98, 0)) << "the tracker goes on without it for a second";
    EXPECT_FALSE(still_there(70, 0));
    EXPECT_FALSE(still_there(98, 20)) << "it left at the border";
}

}  // namespace
}  // namespace vvr
