#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "cli/exit_status.h"
#include "cli/options/parse_value.h"
#include "cli/options/value_types.h"
#include "tests/support/errors.h"

namespace vvr {
namespace {

TEST(ParseTime, TakesFramesSecondsUnitsAndClockTimes) {
    EXPECT_EQ(options::parse_time("250f"), (app::Time{250, app::Time::Unit::frames}));
    EXPECT_EQ(options::parse_time("12.5s"), (app::Time{12.5, app::Time::Unit::seconds}));
    EXPECT_EQ(options::parse_time("0"), (app::Time{0, app::Time::Unit::seconds}));
    EXPECT_EQ(options::parse_time("1h30m"), (app::Time{5400, app::Time::Unit::seconds}));
    EXPECT_EQ(options::parse_time("1d2h3m4.5s"), (app::Time{93784.5, app::Time::Unit::seconds}));
    EXPECT_EQ(options::parse_time("00:00:12.5"), (app::Time{12.5, app::Time::Unit::seconds}));
    EXPECT_EQ(options::parse_time("90:30"), (app::Time{5430, app::Time::Unit::seconds}));
    EXPECT_EQ(options::parse_time("25:01:02.25"), (app::Time{90062.25, app::Time::Unit::seconds}));
}

TEST(ParseTime, RefusesEverythingElse) {
    for (const char* text :
         {"",        "s",      "f",       ":",    "1:",   "-1",   "-1f",   "1.5f",    "1e400s", "nans", "infs", "1:60",
          "1:60:00", "1.5:00", "1:2:3:4", "12 s", "0x10", "1,5s", "30m1h", "1.5h30m", "1h2h",   "10ms", "5w"}) {
        EXPECT_THROW(options::parse_time(text), Error) << text;
    }
}

TEST(ParseTime, AsksForTheUnitOfANumberAlone) {
    test::expect_error(ErrorCode::option_value, [] { options::parse_time("250"); }, {"250f", "250s"});
    test::expect_error(ErrorCode::option_value, [] { options::parse_time("2.5"); }, {"2.5s"});
}

TEST(ParsePlace, TakesTimesOfTheClockOnTheWall) {
    const std::int64_t at = 1'795'312'800;  // 2026-11-22 02:00:00
    const auto asked = [](const char* text) { return std::get<video::RequestedTime>(options::parse_place(text)); };
    EXPECT_EQ(asked("2026-11-22 02:00"), (video::RequestedTime{at, true, "2026-11-22 02:00"}));
    EXPECT_EQ(asked("2026-11-22T02:00:07").seconds, at + 7);
    EXPECT_EQ(asked("@02:00"), (video::RequestedTime{7200, false, "@02:00"}));
    EXPECT_EQ(asked("@23:59:59").seconds, 86'399);
    EXPECT_EQ(asked("@2:00").seconds, 7200);
    EXPECT_EQ(std::get<app::Time>(options::parse_place("02:00")), (app::Time{120, app::Time::Unit::seconds}))
        << "an offset, as ever";
    EXPECT_EQ(std::get<app::Time>(options::parse_place("250f")), (app::Time{250, app::Time::Unit::frames}));
    for (const char* text : {"@", "@24:00", "@02", "@02:60", "2026-02-30 08:00", "2026-11-22", "2026-11-22 :00",
                             "2026-11-22  02:00", "2026-11-22 02:00 ", "2026-11-22X02:00", "2026-13-01 00:00"}) {
        EXPECT_THROW(options::parse_place(text), Error) << text;
    }
    test::expect_error(ErrorCode::option_value, [] { options::parse_place("2026-02-30 08:00"); },
                       {"2026-11-22 02:00", "@02:00"});
}

TEST(ParseDayPart, TakesTwoTimesOfDay) {
    EXPECT_EQ(options::parse_day_part("02:00-05:00"), (video::DayPart{7200, 18'000, "02:00-05:00"}));
    EXPECT_EQ(options::parse_day_part("22:00:30-05:00").begin, 79'230);
    for (const char* text : {"", "02:00", "02:00-", "02:00-02:00", "2-5", "02:00-25:00", "02:00-05:00-07:00"}) {
        EXPECT_THROW(options::parse_day_part(text), Error) << text;
    }
    test::expect_error(ErrorCode::option_value, [] { options::parse_day_part("2-5"); }, {"'2-5'", "02:00-05:00"});
}

TEST(ParseDuration, IsInSecondsWithoutAUnit) {
    EXPECT_EQ(options::parse_duration("90"), 90);
    EXPECT_EQ(options::parse_duration("0.5"), 0.5);
    EXPECT_EQ(options::parse_duration("60s"), 60);
    EXPECT_EQ(options::parse_duration("10m"), 600);
    EXPECT_EQ(options::parse_duration("1.5h"), 5400);
    EXPECT_EQ(options::parse_duration("1d"), 86400);
    EXPECT_EQ(options::parse_duration("00:01:30"), 90);
    EXPECT_EQ(options::parse_whole_seconds("1.2s"), std::chrono::seconds(2));
    for (const char* text : {"", "s", "-1s", "1 h", "2w", "1hs", "250f", "99999999999999999999"}) {
        EXPECT_THROW(options::parse_duration(text), Error) << text;
    }
    test::expect_error(ErrorCode::option_value_out_of_range,
                       [] {
                           options::parse_duration("2m", {0.1, 60});
                       },
                       {"'2m'", "0.1s", "60s"});
}

TEST(ParseBytes, TakesUnits) {
    EXPECT_EQ(options::parse_bytes("5"), 5);
    EXPECT_EQ(options::parse_bytes("500M"), 500'000'000);
    EXPECT_EQ(options::parse_bytes("2GB"), 2'000'000'000);
    for (const char* text : {"", "G", "0", "-1G", "1.5G", "1T", "1 G", "1GG"})
        EXPECT_THROW(options::parse_bytes(text), Error) << text;
}

TEST(ParseShare, CountsFromOne) {
    EXPECT_EQ(options::parse_share("1/1"), (std::pair(1, 1)));
    EXPECT_EQ(options::parse_share("3/8"), (std::pair(3, 8)));
    for (const char* text : {"", "/", "1", "0/2", "3/2", "1/0", "-1/2", "1/2/3", "a/b"})
        EXPECT_THROW(options::parse_share(text), Error) << text;
}

TEST(ParseSize, TakesWhatATextureCanHold) {
    EXPECT_EQ(options::parse_size("1280x800"), (Size{1280, 800}));
    EXPECT_EQ(options::parse_size("1x16384"), (Size{1, 16384}));
    for (const char* text :
         {"", "x", "1x", "x1", "0x1", "1x16385", "1x2x3", "1.5x2", "-1x2", "99999999999999999999x1"}) {
        EXPECT_THROW(options::parse_size(text), Error) << text;
    }
}

TEST(ParseNumber, IsFiniteAndWithinItsRange) {
    EXPECT_EQ(options::parse_number("-2.5e1", {-30, 0}), -25);
    for (const char* text : {"", "nan", "inf", "-inf", "1e999", "1 ", " 1", "1x", "31", "-31", "1,5"}) {
        EXPECT_THROW(options::parse_number(text, {-30, 30}), Error) << text;
    }
}

TEST(ParsePair, NeedsBothNumbers) {
    EXPECT_EQ(options::parse_pair("-20,35", ',', {-360, 360}, {-90, 90}), std::pair(-20.0, 35.0));
    for (const char* text : {"", ",", "1", "1,", ",1", "1,2,3", "1:2", "400,0", "0,100"}) {
        EXPECT_THROW(options::parse_pair(text, ',', {-360, 360}, {-90, 90}), Error) << text;
    }
}

/// A value of the type, printed after it was parsed.
template <class Value>
std::string printed(const std::string& text, const Setting& setting = {.name = "a", .unit = "", .help = ""}) {
    Value value{};
    options::set_value(setting, text, value);
    return options::value_text(setting, value);
}

TEST(ValueText, IsWhatOneWouldType) {
    const Setting time{.name = "a", .unit = "TIME", .help = ""};
    EXPECT_EQ(printed<double>("1m30s", time), "90s");
    EXPECT_EQ(printed<std::chrono::seconds>("900", time), "15m");
    EXPECT_EQ(printed<app::Time>("250f"), "250f");
    EXPECT_EQ(printed<Size>("64x48"), "64x48");
    EXPECT_EQ(printed<space::View>("-20,35.5"), "-20,35.5");
    EXPECT_EQ(printed<glm::vec4>("none"), "none");
    EXPECT_EQ(printed<app::StartTime>("container"), "container");
    EXPECT_EQ(printed<app::StartTime>("2026-11-21T08:00"), "2026-11-21 08:00:00");
    EXPECT_EQ(printed<app::Parts>("outline,volume"), "volume,outline") << "in the order of the table";
    EXPECT_EQ(printed<std::optional<app::NamedTransfer>>("heat"), "heat");
    EXPECT_EQ(printed<fields::SeedSelection>("random:3"), "random:3:1");
    EXPECT_EQ(printed<fields::SeedFlags>("100"), "100");
    for (unsigned grey = 0; grey < 256; ++grey) {
        const std::string colour = fmt::format("#{0:02x}{0:02x}{0:02x}", grey);
        EXPECT_EQ(printed<glm::vec4>(colour), colour);
    }
}

TEST(ValueText, OfPlacesInAClipHasTheUnitThatWasGiven) {
    const Setting setting{.name = "a", .unit = "TIME", .help = ""};
    for (const char* text : {"0s", "1.5s", "25f", "@02:00", "2026-11-22 02:00"}) {
        video::FrameSpan span;
        options::set_value(setting, text, app::SpanStart{span});
        options::set_value(setting, text, app::SpanEnd{span});
        EXPECT_EQ(options::value_text(setting, app::SpanStart{span}), text);
        EXPECT_EQ(options::value_text(setting, app::SpanEnd{span}), text);
    }
}

TEST(ExitStatusTable, HasARowForEveryKind) {
    for (const auto kind : {ErrorKind::usage, ErrorKind::io, ErrorKind::not_video, ErrorKind::backend, ErrorKind::limit,
                            ErrorKind::partial, ErrorKind::differs}) {
        EXPECT_NE(cli::exit_status(kind), cli::ExitStatus::bug);
    }
}

TEST(Values, EventsHaveKindsAndALeastLength) {
    const Setting setting{"events", "LIST", ""};
    events::EventChoice choice;
    EXPECT_EQ(options::value_text(setting, choice), "moved,stood,left,taken");
    const std::pair<const char*, const char*> texts[] = {
        {"left", "left"}, {"taken,left", "left,taken"}, {"left,5s", "left,5s"}, {"1m,moved", "moved,60s"}};
    for (const auto& [given, shown] : texts) {
        options::set_value(setting, given, choice);
        EXPECT_EQ(options::value_text(setting, choice), shown);
    }
    options::set_value(setting, "3s", choice);
    EXPECT_EQ(options::value_text(setting, choice), "moved,stood,left,taken,3s") << "a length alone is of all kinds";
}

TEST(Values, ABackendMayHaveADevice) {
    const Setting setting{"backend", "NAME", ""};
    app::BackendOptions backend;
    EXPECT_EQ(options::value_text(setting, app::BackendAndDevice{backend}), "auto");
    for (const char* text : {"egl:3", "software", "software:0"}) {
        options::set_value(setting, text, app::BackendAndDevice{backend});
        EXPECT_EQ(options::value_text(setting, app::BackendAndDevice{backend}), text);
    }
    EXPECT_THROW(options::set_value(setting, "auto:0", app::BackendAndDevice{backend}), Error);
}

}  // namespace
}  // namespace vvr
