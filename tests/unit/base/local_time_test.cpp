
#include <tuple>

#include <gtest/gtest.h>

#include "core/base/wall_clock.h"
#include "tests/support/zone.h"

namespace vvr {
namespace {

constexpr std::int64_t summer_begins = 1774746000;  // 2026-03-29 01:00 UTC
constexpr std::int64_t summer_ends = 1792890000;    // 2026-10-25 01:00 UTC

TEST(LocalTime, HasTheZonesOffsetsAndWhenTheyChange) {
    const test::InZone berlin("Europe/Berlin");
    EXPECT_EQ(local_offset(summer_begins - 1), 3600);
    EXPECT_EQ(local_offset(summer_begins), 7200);
    EXPECT_EQ(zone_changes(summer_begins - 10, summer_ends + 10),
              (std::vector<ZoneChange>{{summer_begins - 10, 3600}, {summer_begins, 7200}, {summer_ends, 3600}}));
    EXPECT_EQ(zone_changes(summer_begins - 10, summer_begins - 10).size(), 1);
    EXPECT_EQ(zone_text(summer_begins - 1), "CET, UTC+1");
    EXPECT_EQ(zone_text(summer_begins), "CEST, UTC+2");
}

TEST(LocalTime, SaysZonesPlainly) {
    const std::tuple<const char*, std::int64_t, const char*> zones[] = {
        {"UTC", 0, "UTC"},
        {"Asia/Kolkata", summer_begins, "IST, UTC+5:30"},
        {"America/St_Johns", 0, "NST, UTC-3:30"},
        {"America/Sao_Paulo", summer_begins, "UTC-3"}};
    for (const auto& [zone, at, text] : zones) {
        const test::InZone there(zone);
        EXPECT_EQ(zone_text(at), text);
    }
}

TEST(LocalTime, OfAnHourThatComesTwiceIsTheFirstOrTheNearer) {
    const test::InZone berlin("Europe/Berlin");
    const std::int64_t half_past_two = summer_ends + 3600 + 1800;  // on the clock on the wall
    EXPECT_EQ(utc_of_local(half_past_two, std::nullopt), summer_ends - 1800);
    EXPECT_EQ(utc_of_local(half_past_two, summer_ends), summer_ends - 1800);
    EXPECT_EQ(utc_of_local(half_past_two, summer_ends + 7200), summer_ends + 1800);
}

TEST(DateText, IsReadByOneParser) {
    EXPECT_EQ(parse_time_of_day("2:00"), 7200);
    EXPECT_EQ(parse_time_of_day("02:00:30"), 7230);
    for (const char* text : {"", "2", "24:00", "2:60", "02:00:60", "2:0", "02:00x", "-1:00", "2 :00"})
        EXPECT_FALSE(parse_time_of_day(text)) << text;
    EXPECT_EQ(parse_date_time("1970-01-02 08:00:00"), 86'400 + 8 * 3600);
    EXPECT_EQ(parse_date_time("2024-02-29T08:00"), parse_date_time("2024-02-29 08:00:00"));
    for (const char* text :
         {"", "2026-11-21", "2026-02-30 08:00", "2026-13-01 08:00", "2026-11-21 24:00", "2026-11-21 08:00 x"})
        EXPECT_FALSE(parse_date_time(text)) << text;
    EXPECT_EQ(seconds_of_date(1970, 1, 1), 0);
    EXPECT_FALSE(seconds_of_date(2025, 2, 29));
    EXPECT_TRUE(is_date_text("2026-11-21"));
    EXPECT_FALSE(is_date_text("2026-1-21"));
}

}  // namespace
}  // namespace vvr
