#include <utility>

#include <gtest/gtest.h>

#include "cli/exit_status.h"
#include "cli/options/parse_value.h"

namespace vvr {
namespace {

TEST(ParseTime, TakesFramesSecondsUnitsAndClockTimes) {
    EXPECT_EQ(parse_time("250f"), (Time{250, Time::Unit::frames}));
    EXPECT_EQ(parse_time("12.5s"), (Time{12.5, Time::Unit::seconds}));
    EXPECT_EQ(parse_time("0"), (Time{0, Time::Unit::seconds}));
    EXPECT_EQ(parse_time("1h30m"), (Time{5400, Time::Unit::seconds}));
    EXPECT_EQ(parse_time("1d2h3m4.5s"), (Time{93784.5, Time::Unit::seconds}));
    EXPECT_EQ(parse_time("00:00:12.5"), (Time{12.5, Time::Unit::seconds}));
    EXPECT_EQ(parse_time("90:30"), (Time{5430, Time::Unit::seconds}));
    EXPECT_EQ(parse_time("25:01:02.25"), (Time{90062.25, Time::Unit::seconds}));
}

TEST(ParseTime, RefusesEverythingElse) {
    for (const char* text :
         {"",        "s",      "f",       ":",    "1:",   "-1",   "-1f",   "1.5f",    "1e400s", "nans", "infs", "1:60",
          "1:60:00", "1.5:00", "1:2:3:4", "12 s", "0x10", "1,5s", "30m1h", "1.5h30m", "1h2h",   "10ms", "5w"}) {
        EXPECT_THROW(parse_time(text), Error) << text;
    }
}

/// What an error says.
template <class Action>
std::string refusal(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(ParseTime, AsksForTheUnitOfANumberAlone) {
    EXPECT_EQ(refusal([] { parse_time("250"); }), "'250' has no unit: write 250f for frames or 250s for seconds");
    EXPECT_EQ(refusal([] { parse_time("2.5"); }), "'2.5' has no unit: write 2.5s for seconds");
}

TEST(ParseDuration, IsInSecondsWithoutAUnit) {
    EXPECT_EQ(parse_duration("90"), 90);
    EXPECT_EQ(parse_duration("0.5"), 0.5);
    EXPECT_EQ(parse_duration("60s"), 60);
    EXPECT_EQ(parse_duration("10m"), 600);
    EXPECT_EQ(parse_duration("1.5h"), 5400);
    EXPECT_EQ(parse_duration("1d"), 86400);
    EXPECT_EQ(parse_duration("00:01:30"), 90);
    EXPECT_EQ(parse_whole_seconds("1.2s"), std::chrono::seconds(2));
    for (const char* text : {"", "s", "-1s", "1 h", "2w", "1hs", "250f", "99999999999999999999"}) {
        EXPECT_THROW(parse_duration(text), Error) << text;
    }
    EXPECT_EQ(refusal([] { parse_duration("2m", {0.1, 60}); }), "'2m' is not a length of time from 0.1s to 60s");
}

TEST(ParseBytes, TakesUnits) {
    EXPECT_EQ(parse_bytes("5"), 5);
    EXPECT_EQ(parse_bytes("500M"), 500'000'000);
    EXPECT_EQ(parse_bytes("2GB"), 2'000'000'000);
    for (const char* text : {"", "G", "0", "-1G", "1.5G", "1T", "1 G", "1GG"})
        EXPECT_THROW(parse_bytes(text), Error) << text;
}

TEST(ParseShare, CountsFromOne) {
    EXPECT_EQ(parse_share("1/1"), (std::pair(1, 1)));
    EXPECT_EQ(parse_share("3/8"), (std::pair(3, 8)));
    for (const char* text : {"", "/", "1", "0/2", "3/2", "1/0", "-1/2", "1/2/3", "a/b"})
        EXPECT_THROW(parse_share(text), Error) << text;
}

TEST(ParseSize, TakesWhatATextureCanHold) {
    EXPECT_EQ(parse_size("1280x800"), (Size{1280, 800}));
    EXPECT_EQ(parse_size("1x16384"), (Size{1, 16384}));
    for (const char* text :
         {"", "x", "1x", "x1", "0x1", "1x16385", "1x2x3", "1.5x2", "-1x2", "99999999999999999999x1"}) {
        EXPECT_THROW(parse_size(text), Error) << text;
    }
}

TEST(ParseNumber, IsFiniteAndWithinItsRange) {
    EXPECT_EQ(parse_number("-2.5e1", {-30, 0}), -25);
    for (const char* text : {"", "nan", "inf", "-inf", "1e999", "1 ", " 1", "1x", "31", "-31", "1,5"}) {
        EXPECT_THROW(parse_number(text, {-30, 30}), Error) << text;
    }
}

TEST(ParsePair, NeedsBothNumbers) {
    EXPECT_EQ(parse_pair("-20,35", ',', {-360, 360}, {-90, 90}), std::pair(-20.0, 35.0));
    for (const char* text : {"", ",", "1", "1,", ",1", "1,2,3", "1:2", "400,0", "0,100"}) {
        EXPECT_THROW(parse_pair(text, ',', {-360, 360}, {-90, 90}), Error) << text;
    }
}

TEST(ExitStatusTable, HasARowForEveryKind) {
    for (const auto kind : {ErrorKind::usage, ErrorKind::io, ErrorKind::not_video, ErrorKind::backend, ErrorKind::limit,
                            ErrorKind::partial, ErrorKind::differs}) {
        EXPECT_NE(exit_status(kind), ExitStatus::bug);
    }
}

}  // namespace
}  // namespace vvr
