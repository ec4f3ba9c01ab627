#include "core/tracking/identify.h"

#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace vvr::tracking {
namespace {

Look look(std::string_view name, double score) {
    return {detector::find_class(name), score};
}

Event event_of(EventKind kind, double first, double last) {
    Event event;
    event.kind = kind;
    event.first = {static_cast<std::int64_t>(first * 10), first};
    event.last = {static_cast<std::int64_t>(last * 10), last};
    event.box = {10, 20, 20, 40};
    event.evidence = Evidence{.confidence = 0.8};
    return event;
}

TEST(Identity, IsWhatTheLooksAgreeOn) {
    const std::vector<Look> looks{look("car", 0.6), look("person", 0.9), look("truck", 0.7)};
    const auto identity = identity_of(looks);
    ASSERT_TRUE(identity);
    EXPECT_EQ(identity->what->name, "truck") << "both are vehicles";
    EXPECT_EQ(identity->score, 0.7);
    EXPECT_EQ(identity->looks, 2);
}

TEST(Identity, NeedsAScore) {
    EXPECT_FALSE(identity_of({}));
    EXPECT_FALSE(identity_of(std::vector<Look>{look("person", 0.49), {}}));
    EXPECT_TRUE(identity_of(std::vector<Look>{look("person", 0.5)}));
}

TEST(Claims, OfWhatLivesOrDrivesAreRefuted) {
    for (const std::string_view name : {"person", "dog", "bus"}) {
        Findings found;
        found.events = {event_of(EventKind::left, 5, 9)};
        found.events[0].by = 0;
        found.events[0].alone_since = Moment{60, 6};
        identify(found, std::vector<std::vector<Look>>{{look(name, 0.8)}});
        const Event& event = found.events[0];
        EXPECT_EQ(event.kind, EventKind::stood) << name;
        EXPECT_EQ(event.evidence->refuted, EventKind::left);
        EXPECT_EQ(event.evidence->confidence, 0.8);
        EXPECT_FALSE(event.by || event.alone_since);
        EXPECT_EQ(event.first.seconds, 5);
    }
}

TEST(Claims, OfThingsStay) {
    for (const std::vector<Look>& looks :
         {std::vector<Look>{look("suitcase", 0.9)}, {look("chair", 0.9)}, {look("person", 0.3)}, {Look{}}, {}}) {
        Findings found;
        found.events = {event_of(EventKind::left, 5, 9), event_of(EventKind::taken, 5, 9)};
        identify(found, std::vector<std::vector<Look>>{looks, looks});
        EXPECT_EQ(found.events[0].kind, EventKind::left);
        EXPECT_EQ(found.events[1].kind, EventKind::taken);
        EXPECT_FALSE(found.events[0].evidence->refuted);
    }
}

TEST(Claims, OfAPersonInTheEmptySceneAreOfWhoStoodThere) {
    Findings found;
    found.begins = {{0, 0}, {30, 3}, {80, 8}};
    found.events = {event_of(EventKind::moved, 4, 9), event_of(EventKind::moved, 4.5, 9),
                    event_of(EventKind::taken, 5, 9)};
    found.events[0].into = 2;
    identify(found, std::vector<std::vector<Look>>{{}, {}, {look("person", 0.8)}});
    EXPECT_EQ(found.events[1].into, 0U) << "events are listed by their first frames";
    const Event& event = found.events[0];
    EXPECT_EQ(event.kind, EventKind::stood);
    EXPECT_EQ(event.first.seconds, 3) << "as long as that stretch of the recording shows the place";
    EXPECT_EQ(event.last.seconds, 5) << "then it was empty";
    ASSERT_EQ(event.stays.size(), 1U);
    EXPECT_EQ(event.stays[0].box, event.box);
    EXPECT_EQ(event.path.size(), 2U);
}

/// Somebody, of whom a part is an event of its own: `apart` field pixels beside, unless it is seen in the same box.
Findings in_two_parts(double apart, EventKind kind = EventKind::moved) {
    Findings found;
    found.events = {event_of(EventKind::moved, 0, 9), event_of(kind, 2, 8), event_of(EventKind::moved, 8, 9)};
    for (Event& event : found.events) {
        const double off = &event == &found.events[1] ? apart : 0;
        event.path = {{event.first, {15 + off, 30}}, {event.last, {15 + off, 30}}};
    }
    found.events[0].tracks = {7};
    found.events[1].tracks = {8, 9};
    found.events[2].from = 1;
    return found;
}

std::vector<std::vector<Look>> looks_at_both(double apart) {
    const int off = static_cast<int>(apart);
    const Moment then{50, 5};
    return {{{detector::find_class("person"), 0.8, then, {10, 20, 20, 40}}},
            {{detector::find_class("person"), 0.7, then, {10 + off, 20, 20 + off, 40}}},
            {}};
}

TEST(Parts, ThatTheDetectorSeesInOneBoxAreOneObject) {
    Findings found = in_two_parts(3);
    identify(found, looks_at_both(3));
    ASSERT_EQ(found.events.size(), 2U);
    EXPECT_EQ(found.events[0].tracks, (std::vector<std::size_t>{7, 8, 9}));
    EXPECT_EQ(found.events[1].from, 0U) << "what came out of the part came out of the whole";
}

TEST(Parts, OfTwoPeopleStayTwo) {
    Findings found = in_two_parts(12);
    identify(found, looks_at_both(12));
    EXPECT_EQ(found.events.size(), 3U);
}

TEST(Parts, AreNeverThings) {
    Findings found = in_two_parts(3, EventKind::left);
    identify(found, std::vector<std::vector<Look>>{looks_at_both(3)[0], {}, {}});
    EXPECT_EQ(found.events.size(), 3U);
}

}  // namespace
}  // namespace vvr::tracking
