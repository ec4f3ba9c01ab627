#include <utility>

#include <gtest/gtest.h>

#include "cli/exit_status.h"
#include "cli/options/parse_value.h"

namespace vvr {
namespace {

TEST(ParseTime, TakesFramesSecondsAndClockTimes) {
    EXPECT_EQ(parse_time("250"), (Time{250, Time::Unit::frames}));
    EXPECT_EQ(parse_time("12.5s"), (Time{12.5, Time::Unit::seconds}));
    EXPECT_EQ(parse_time("00:00:12.5"), (Time{12.5, Time::Unit::seconds}));
    EXPECT_EQ(parse_time("90:30"), (Time{5430, Time::Unit::seconds}));
    EXPECT_EQ(parse_time("25:01:02.25"), (Time{90062.25, Time::Unit::seconds}));
}

TEST(ParseTime, RefusesEverythingElse) {
    for (const char* text : {"", "s", ":", "1:", "-1", "1.5", "1e400s", "nans", "infs", "1:60", "1:60:00", "1.5:00",
                             "1:2:3:4", "12 s", "0x10", "1,5s"}) {
        EXPECT_THROW(parse_time(text), Error) << text;
    }
}

TEST(ParseDuration, TakesUnits) {
    EXPECT_EQ(parse_duration("90"), std::chrono::seconds(90));
    EXPECT_EQ(parse_duration("60s"), std::chrono::seconds(60));
    EXPECT_EQ(parse_duration("10m"), std::chrono::minutes(10));
    EXPECT_EQ(parse_duration("2h"), std::chrono::hours(2));
    EXPECT_EQ(parse_duration("1d"), std::chrono::hours(24));
    for (const char* text : {"", "s", "-1s", "1.5h", "1 h", "2w", "1hs", "99999999999999999999"}) {
        EXPECT_THROW(parse_duration(text), Error) << text;
    }
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
