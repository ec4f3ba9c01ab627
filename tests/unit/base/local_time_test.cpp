#include <cstdlib>
#include <ctime>

#include <gtest/gtest.h>

#include "core/base/wall_clock.h"

namespace vvr {
namespace {

class LocalTime : public testing::Test {
  protected:
    static void live_in(const char* zone) {
        ::setenv("TZ", zone, 1);
        ::tzset();
    }
    void TearDown() override { live_in("UTC"); }
};

constexpr std::int64_t summer_begins = 1774746000;  // 2026-03-29 01:00 UTC
constexpr std::int64_t summer_ends = 1792890000;    // 2026-10-25 01:00 UTC

TEST_F(LocalTime, HasTheZonesOffsetsAndWhenTheyChange) {
    live_in("Europe/Berlin");
    EXPECT_EQ(local_offset(summer_begins - 1), 3600);
    EXPECT_EQ(local_offset(summer_begins), 7200);
    EXPECT_EQ(zone_changes(summer_begins - 10, summer_ends + 10),
              (std::vector<ZoneChange>{{summer_begins - 10, 3600}, {summer_begins, 7200}, {summer_ends, 3600}}));
    EXPECT_EQ(zone_changes(summer_begins - 10, summer_begins - 10).size(), 1);
    EXPECT_EQ(zone_text(summer_begins - 1), "CET, UTC+1");
    EXPECT_EQ(zone_text(summer_begins), "CEST, UTC+2");
}

TEST_F(LocalTime, SaysZonesPlainly) {
    live_in("UTC");
    EXPECT_EQ(zone_text(0), "UTC");
    live_in("Asia/Kolkata");
    EXPECT_EQ(zone_text(summer_begins), "IST, UTC+5:30");
    live_in("America/St_Johns");
    EXPECT_EQ(zone_text(0), "NST, UTC-3:30");
    live_in("America/Sao_Paulo");
    EXPECT_EQ(zone_text(summer_begins), "UTC-3");
}

TEST_F(LocalTime, OfAnHourThatComesTwiceIsTheFirstOrTheNearer) {
    live_in("Europe/Berlin");
    const std::int64_t half_past_two = summer_ends + 3600 + 1800;  // on the clock on the wall
    EXPECT_EQ(utc_of_local(half_past_two, std::nullopt), summer_ends - 1800);
    EXPECT_EQ(utc_of_local(half_past_two, summer_ends), summer_ends - 1800);
    EXPECT_EQ(utc_of_local(half_past_two, summer_ends + 7200), summer_ends + 1800);
}

}  // namespace
}  // namespace vvr
