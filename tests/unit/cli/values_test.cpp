#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cli/exit_status.h"
#include "cli/options/command_line.h"
#include "cli/options/config_file.h"
#include "cli/options/parse_value.h"
#include "cli/options/value.h"
#include "cli/plan/settings.h"
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
    const auto asked = [](const char* text) { return std::get<media::RequestedTime>(options::parse_place(text)); };
    EXPECT_EQ(asked("2026-11-22 02:00"), (media::RequestedTime{at, true, "2026-11-22 02:00"}));
    EXPECT_EQ(asked("2026-11-22T02:00:07").seconds, at + 7);
    EXPECT_EQ(asked("@02:00"), (media::RequestedTime{7200, false, "@02:00"}));
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
    EXPECT_EQ(options::parse_day_part("02:00-05:00"), (media::DayPart{7200, 18'000, "02:00-05:00"}));
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

TEST(ParseRate, TakesFractionsAndDurations) {
    const Range range{0.00001, 1000};
    EXPECT_EQ(options::parse_rate("29.97", range), 29.97);
    EXPECT_EQ(options::parse_rate("30000/1001", range), 30000.0 / 1001);
    EXPECT_EQ(options::parse_rate("1/24s", range), 1.0 / 24);
    EXPECT_EQ(options::parse_rate("1/24", range), 1.0 / 24);
    EXPECT_EQ(options::parse_rate("4/1h", range), 4.0 / 3600);
    for (const char* text : {"", "/", "1/", "/24", "1/0", "1/24x", "-1/24", "1/2/3", "24s"})
        EXPECT_THROW(options::parse_rate(text, range), Error) << text;
    test::expect_error(ErrorCode::option_value, [&] { options::parse_rate("1/x", range); }, {"'1/x'", "1/24s"});
    test::expect_error(ErrorCode::option_value_out_of_range, [&] { options::parse_rate("1/2d", range); },
                       {"'1/2d'", "frames per second"});
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
template <class Type>
std::string printed(const std::string& text, const Setting& setting = {.name = "a", .unit = "", .help = ""}) {
    Type variable{};
    const options::Value value = options::value_of(setting, variable);
    value.set(text);
    return value.text();
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
    for (const char* text : {"0s", "1.5s", "25f", "@02:00", "2026-11-22 02:00"}) {
        EXPECT_EQ(printed<media::FrameSpan>(text, setting::start), text);
        EXPECT_EQ(printed<media::FrameSpan>(text, setting::end), text);
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
    tracking::EventChoice choice;
    const options::Value value = options::value_of(setting, choice);
    EXPECT_EQ(value.text(), "moved,stood,left,taken,changed");
    const std::pair<const char*, const char*> texts[] = {
        {"left", "left"}, {"taken,left", "left,taken"}, {"left,5s", "left,5s"}, {"1m,moved", "moved,60s"}};
    for (const auto& [given, shown] : texts) {
        value.set(given);
        EXPECT_EQ(value.text(), shown);
    }
    value.set("3s");
    EXPECT_EQ(value.text(), "moved,stood,left,taken,changed,3s") << "a length alone is of all kinds";
}

TEST(Values, ABackendMayHaveADevice) {
    const Setting setting{"backend", "NAME", ""};
    app::BackendOptions backend;
    const options::Value value = options::value_of(setting, backend);
    EXPECT_EQ(value.text(), "auto");
    for (const char* text : {"egl:3", "software", "software:0"}) {
        value.set(text);
        EXPECT_EQ(value.text(), text);
    }
    EXPECT_THROW(value.set("auto:0"), Error);
}

TEST(Values, AWordStandsForWhatNoNumberSays) {
    int slices = 40;
    const options::Value number = options::value_of(setting::slices, slices, app::Word{"auto"});
    number.set("auto");
    EXPECT_EQ(slices, 0);
    EXPECT_EQ(number.text(), "auto");
    Size field{0, 0};
    const options::Value size = options::value_of(setting::field_size, field, app::Word{"source"});
    EXPECT_EQ(size.text(), "") << "none is given";
    size.set("source");
    EXPECT_EQ(size.text(), "source");
    test::expect_error(ErrorCode::option_value, [] { printed<Size>("source", setting::size); }, {"'source'"});
}

TEST(Values, FlagsTakeTheWordsOfConfigFiles) {
    for (const char* text : {"true", "on", "Yes", "1"}) EXPECT_EQ(printed<bool>(text), "true") << text;
    for (const char* text : {"false", "off", "NO", "0"}) EXPECT_EQ(printed<bool>(text), "") << text;
    test::expect_error(ErrorCode::option_value, [] { printed<bool>("maybe"); }, {"'maybe'"});
}

using Given = std::vector<std::pair<std::string, std::string>>;

/// The record of a few options that were given as data.
image::Metadata taken(const Given& settings, bool of_worker = false) {
    int slices = 0;
    std::vector<std::string> names;
    std::string hidden;
    options::CommandLine line("draw", "");
    const options::AddOptions add(line, options::Group::look);
    add(setting::slices, slices);
    add(setting::names, names);
    options::AddOptions(line, options::Group::plan)({"hidden", "", ""}, hidden);
    line.take({}, settings, of_worker);
    return line.record(std::array{options::Group::look, options::Group::plan});
}

TEST(Registry, TakesTheLastOfEqualNamesAndAllOfAList) {
    EXPECT_EQ(taken({{"slices", "4"}, {"names", "a"}, {"slices", "5"}, {"names", "b"}}),
              (image::Metadata{{"slices", "5"}, {"names", "a b"}}));
}

TEST(Registry, NamesTheNearestSetting) {
    test::expect_error(ErrorCode::option_unknown, [] { taken({{"slises", "4"}}); }, {"'slises'", "'slices'"});
    test::expect_error(ErrorCode::option_value, [] { taken({{"slices", "few"}}); }, {"slices: 'few'"});
}

TEST(Registry, OnlyAWorkerHasTheSettingsOfAPlan) {
    EXPECT_NO_THROW(taken({{"hidden", "x"}}, true));
    test::expect_error(ErrorCode::option_unknown, [] { taken({{"hidden", "x"}}); }, {"'hidden'"});
}

TEST(ConfigFile, HasCommentsQuotesListsAndCameras) {
    const auto sections =
        options::sections_of("fov = 3 # or 4\n[camera.\"a.b\"]\ntitle = '#1'\nnames = [\"x\", 'y']\n", "f");
    ASSERT_EQ(sections.size(), 2U);
    EXPECT_EQ(sections[0].settings, (decltype(sections[0].settings){{"fov", {"3"}}}));
    EXPECT_EQ(options::cameras_of(sections), std::vector<std::string>{"a.b"});
    EXPECT_EQ(sections[1].settings, (decltype(sections[0].settings){{"title", {"#1"}}, {"names", {"x", "y"}}}));
}

TEST(ConfigFile, RefusesASectionThatIsThereTwice) {
    test::expect_error(ErrorCode::config_invalid,
                       [] { options::sections_of("[camera.a]\nfov = 3\n[b]\n[camera.\"a\"] # again\n", "vvr.toml"); },
                       {"'vvr.toml'", "lines 1 and 4", "[camera.a]"});
}

}  // namespace
}  // namespace vvr
