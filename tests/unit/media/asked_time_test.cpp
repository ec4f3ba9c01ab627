
#include <gtest/gtest.h>

#include "core/media/frame_span.h"
#include "tests/support/errors.h"
#include "tests/support/zone.h"

namespace vvr {
namespace {

constexpr double hour = 3600;
constexpr std::int64_t evening = 1'795'291'200;  // 2026-11-21 20:00:00

/// 12 hours from 20:00 on, as its name says.
media::VideoInfo night() {
    media::VideoInfo info;
    info.name = "gate";
    info.duration = 12 * hour;
    info.rate = 10;
    info.frames = 12 * 36'000;
    return info;
}

Clock clock_of(std::int64_t begin) {
    Clock clock(begin);
    clock.source = ClockSource::file_name;
    return clock;
}

media::FrameSpan asked(std::optional<media::RequestedTime> start, std::optional<media::RequestedTime> end = {},
                       std::optional<media::DayPart> between = {}) {
    media::FrameSpan span;
    span.asked = {std::move(start), std::move(end), std::move(between)};
    return span;
}

TEST(RequestedTime, IsASecondOfTheClip) {
    const media::RequestedTime dated{evening + 6 * 3600, true, "2026-11-22 02:00"};
    const media::RequestedTime of_day{2 * 3600, false, "@02:00"};
    EXPECT_EQ(media::seconds_of(dated, clock_of(evening)), 6 * hour);
    EXPECT_EQ(media::seconds_of(of_day, clock_of(evening)), 6 * hour) << "the next that comes is tomorrow's";
    EXPECT_EQ(media::seconds_of({20 * 3600, false, ""}, clock_of(evening)), 0) << "its own first second counts";
    EXPECT_EQ(media::seconds_of(of_day, clock_of(evening), 6 * hour + 1), 30 * hour) << "after a start, the next again";

    const media::FrameSpan span =
        media::resolve(asked(of_day, media::RequestedTime{5 * 3600, false, "@05:00"}), clock_of(evening), night());
    EXPECT_EQ(span.start, 6 * hour);
    EXPECT_EQ(span.end, 9 * hour);
    EXPECT_EQ(span.asked, media::RequestedSpan{});
    EXPECT_EQ(media::day_times_of(span, clock_of(evening), night()),
              "2026-11-22 02:00:00 to 2026-11-22 05:00:00 (by file name)");
    media::FrameSpan offset;
    offset.start = 2 * hour;
    EXPECT_EQ(media::day_times_of(offset, clock_of(evening), night()),
              "2026-11-21 22:00:00 to the end at 2026-11-22 08:00:00 (by file name)")
        << "what 02:00:00 without an @ means";
    EXPECT_EQ(media::day_times_of(offset, std::nullopt, night()), "");
    EXPECT_EQ(media::day_times_of({.start = offset.start, .end = 1e6}, clock_of(evening), night()),
              media::day_times_of({.start = offset.start}, clock_of(evening), night()))
        << "nothing is read after the end";
    EXPECT_EQ(media::resolve(asked(media::RequestedTime{evening - 60, true, ""}), clock_of(evening), night()).start, 0)
        << "before it begins is its beginning";
}

TEST(RequestedTime, FollowsSummerTime) {
    const test::InZone berlin("Europe/Berlin");
    // From 2026-03-28 23:30 for eight hours: at 2:00 clocks are put forward to 3:00.
    const Clock forward = local_clock(1'774'737'000, 8 * hour, ClockSource::file_name);
    EXPECT_EQ(media::seconds_of({3600 + 1800, false, ""}, forward), 2 * hour);
    EXPECT_EQ(media::seconds_of({3 * 3600, false, ""}, forward), 2.5 * hour);
    EXPECT_EQ(media::seconds_of({4 * 3600, false, ""}, forward), 3.5 * hour);
    EXPECT_EQ(media::seconds_of({2 * 3600 + 1800, false, ""}, forward), 2.5 * hour)
        << "no clock showed that: at the leap";
    // From 2026-10-25 02:00 CEST: the hour comes twice, and the first is meant.
    const Clock back = local_clock(1'792'886'400, 8 * hour, ClockSource::file_name);
    EXPECT_EQ(media::seconds_of({2 * 3600 + 1800, false, ""}, back), 0.5 * hour);
    EXPECT_EQ(media::seconds_of({3 * 3600, false, ""}, back), 2 * hour);
    EXPECT_EQ(back.when(back.at(0) - 60), -60) << "before it began";
}

TEST(Between, IsAPartOfEachDay) {
    media::VideoInfo days = night();
    days.duration = 60 * hour;
    days.frames = 60 * 36'000;
    const auto between = [&](std::int64_t begin, std::int64_t end, const media::VideoInfo& info) {
        return media::resolve(asked({}, {}, media::DayPart{begin * 3600, end * 3600, "it"}), clock_of(evening), info);
    };
    const media::FrameSpan nights = between(2, 5, days);
    ASSERT_EQ(nights.parts.size(), 3U);  // the nights to the 22nd, 23rd and 24th
    EXPECT_EQ(nights.parts[0], (media::FrameSpan::Part{6 * hour, 9 * hour}));
    EXPECT_EQ(nights.parts[2], (media::FrameSpan::Part{54 * hour, 57 * hour}));
    EXPECT_EQ(nights.start, 6 * hour);
    EXPECT_EQ(nights.end, 57 * hour);
    EXPECT_FALSE(media::is_between_parts(nights, 6 * hour));
    EXPECT_TRUE(media::is_between_parts(nights, 9 * hour));
    EXPECT_TRUE(media::is_between_parts(nights, 20 * hour));
    EXPECT_FALSE(media::is_between_parts(nights, 30 * hour));
    EXPECT_EQ(media::expected_frames(days, nights), 3 * 3 * 36'000);

    const media::FrameSpan over_midnight = between(22, 5, night());
    EXPECT_TRUE(over_midnight.parts.empty()) << "one part is a span";
    EXPECT_EQ(over_midnight.start, 2 * hour);
    EXPECT_EQ(over_midnight.end, 9 * hour);
    EXPECT_EQ(between(19, 21, night()).start, 0) << "it has begun already";
    EXPECT_EQ(between(19, 21, night()).end, hour);

    media::FrameSpan later =
        asked(media::RequestedTime{evening + 4 * 3600, true, ""}, {}, media::DayPart{22 * 3600, 5 * 3600, ""});
    later = media::resolve(later, clock_of(evening), night());
    EXPECT_EQ(later.start, 4 * hour) << "within the other limits";
    EXPECT_EQ(later.end, 9 * hour);
}

TEST(RequestedTime, NeedsAClock) {
    const media::RequestedTime two{7200, false, "@02:00"};
    const media::DayPart minute{0, 60, "00:00-00:01"};
    media::VideoInfo written = night();
    written.created = evening;
    const auto resolve = [](const media::FrameSpan& span, const media::VideoInfo& info) {
        return [=] { media::resolve(span, std::nullopt, info); };
    };
    test::expect_error(ErrorCode::time_of_day_unknown, resolve(asked(two), night()),
                       {"start @02:00", "'gate'", "--names"});
    test::expect_error(ErrorCode::time_of_day_unknown, resolve(asked(two), written), {"--start-time container"});
    test::expect_error(ErrorCode::time_of_day_unknown, resolve(asked({}, {}, minute), night()),
                       {"between 00:00-00:01"});
}

TEST(RequestedTime, HasToBeInTheClip) {
    const auto resolve = [](const media::FrameSpan& span) {
        return [=] { media::resolve(span, clock_of(evening), night()); };
    };
    test::expect_error(ErrorCode::span_empty, resolve(asked(media::RequestedTime{12 * 3600, false, "@12:00"})),
                       {"start: @12:00", "'gate'", "2026-11-21 20:00:00", "2026-11-22 08:00:00"});
    const media::RequestedTime before{evening - 60, true, "2026-11-21 19:59"};
    test::expect_error(ErrorCode::span_empty, resolve(asked({}, before)), {"end: 2026-11-21 19:59", "'gate'"});
    const media::RequestedTime later{evening + 7200, true, "2026-11-21 22:00"};
    const media::RequestedTime sooner{evening + 3600, true, "2026-11-21 21:00"};
    test::expect_error(ErrorCode::span_empty, resolve(asked(later, sooner)),
                       {"end: 2026-11-21 21:00", "2026-11-21 22:00:00"});
    test::expect_error(ErrorCode::span_empty,
                       resolve(asked({}, {}, media::DayPart{12 * 3600, 13 * 3600, "12:00-13:00"})),
                       {"between: 12:00-13:00", "'gate'"});
}

TEST(FrameSpan, TellsWhatWasLeftOutFromLossesOfSignal) {
    const media::FrameSpan span{.parts = {{10, 20}, {100, 120}}};
    EXPECT_EQ(media::reason_for_gap({}, {}, {}, 20, 100), "no signal");
    EXPECT_EQ(media::reason_for_gap(span, {}, {}, 12, 18), "no signal");
    EXPECT_EQ(media::reason_for_gap(span, {}, {}, 20, 100), "left out");
    EXPECT_EQ(media::reason_for_gap(span, {}, {}, 19.5, 100), "left out") << "a part has frames up to its end, about";
    EXPECT_EQ(media::reason_for_gap(span, {}, {}, 15, 100), "left out, no signal");
    EXPECT_EQ(media::reason_for_gap(span, {}, {}, 15, 20.5), "no signal");
    // Nobody knows whether a camera without a file between two files had no signal: it may record only motion.
    const std::vector<media::SegmentPlace> files{{"a", 0, 60}, {"b", 90, 130}};
    EXPECT_EQ(media::reason_for_gap({}, files, {}, 60, 89.9), "no footage");
    EXPECT_EQ(media::reason_for_gap({}, files, {}, 60.1, 80), "no footage") << "the layers beside it have the rest";
    EXPECT_EQ(media::reason_for_gap({}, files, {}, 95, 105), "no signal") << "within a file";
    EXPECT_EQ(media::reason_for_gap(span, files, {}, 60, 90), "left out");
    EXPECT_EQ(media::reason_for_gap({.parts = {{0, 70}, {80, 120}}}, files, {}, 60, 90), "left out, no footage");
}

TEST(FrameSpan, ToleratesTimesThatWereRounded) {
    media::FrameSpan span;
    span.start = 1.04;
    span.end = 2.08;
    EXPECT_TRUE(media::is_before(span, 0, 1));
    EXPECT_FALSE(media::is_before(span, 0, 1.0399));
    EXPECT_FALSE(media::is_past(span, 0, 2.04));
    EXPECT_TRUE(media::is_past(span, 0, 2.0799)) << "the end belongs to what follows";
    EXPECT_TRUE(media::is_past(span, 0, 2.08));
}

}  // namespace
}  // namespace vvr
