#include "cli/observe/objects.h"

#include <array>

#include <gtest/gtest.h>

#include "core/tracking/event_line.h"
#include "core/tracking/path.h"

namespace vvr {
namespace {

/// Somebody who goes to the right for 20 s, ten frames per second.
tracking::Event walker() {
    tracking::Event event;
    for (int f = 0; f <= 200; ++f) event.path.push_back({{f, f / 10.0}, {f, 50}});
    event.first = event.path.front().at;
    event.last = event.path.back().at;
    event.path_length = tracking::length_of(event.path);
    return event;
}

TEST(EventsBetween, GoWhereTheyGoInThatTime) {
    const app::ShownEvents shown = app::events_between(std::array{walker()}, 8, 10);
    ASSERT_EQ(shown.events.size(), 1U);
    EXPECT_EQ(shown.events[0].path.size(), 21U);
    EXPECT_EQ(tracking::direction_of(shown.events[0]), "right") << "a tenth of the way is not to and fro";
}

TEST(DirectionOf, AThingThatNobodySawMoveIsNone) {
    tracking::Event parked = walker();
    parked.kind = tracking::EventKind::stood;
    EXPECT_EQ(tracking::direction_of(parked), "right");
    parked.evidence.emplace();
    EXPECT_EQ(tracking::direction_of(parked), "");
}

}  // namespace
}  // namespace vvr
