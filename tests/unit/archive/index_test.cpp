#include "core/archive/index.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/archive/sidecar.h"
#include "core/base/error.h"
#include "core/footage/recorder_names.h"
#include "tests/support/zone.h"
#include "tests/unit/archive/archive.h"

namespace vvr {
namespace {

using Json = nlohmann::ordered_json;
using test::Archive;

TEST_F(Archive, IndexesAnyTimesWithoutCountingDays) {
    const test::InZone berlin("Europe/Berlin");
    archive::Sidecar early = done("a.avi");
    archive::Sidecar late = done("b.avi");
    late.clip.modified = std::int64_t{7'258'000'000} * 1'000'000'000;
    const std::string text = archive::make_index({early, late});
    EXPECT_NE(text.find(R"("zone":[[1,3600,"CET, UTC+1"],[7258000000,3600,"CET, UTC+1"]])"), std::string::npos);
}

TEST_F(Archive, TakesCameraAndTimeFromNamesFirst) {
    const test::InZone berlin("Europe/Berlin");
    archive::Sidecar sidecar = done("2026-11-21/07/gate/00.07.mp4");
    sidecar.recorded = "2020-01-01 00:00:00";
    EXPECT_EQ(archive::begin_of(sidecar).utc, 1795244407) << "Frigate's are in UTC";
    const std::vector<std::string> local{"%Y-%m-%d/%H/{camera}/%M.%S"};
    EXPECT_EQ(archive::begin_of(sidecar, footage::RecorderNames(local)).utc, 1795244407 - 3600);
    const std::string text = archive::make_index({sidecar, done("2026-03-29/00/hall/59.00.mp4")});
    EXPECT_NE(text.find(R"("cameras":["gate","hall"])"), std::string::npos);
    EXPECT_NE(text.find(R"("zone":[[1774745940,3600,"CET, UTC+1"],[1774746000,7200,"CEST, UTC+2"],)"
                        R"([1792890000,3600,"CET, UTC+1"]])"),
              std::string::npos);
}

TEST_F(Archive, IsIndexedByItsSidecars) {
    archive::Sidecar sidecar = done("cam/a</script>\"\xFF.avi");
    sidecar.recorded = "2026-11-21 08:00:07";
    sidecar.seconds = 12.5;
    EXPECT_EQ(archive::begin_of(sidecar).utc, 1795248007);
    EXPECT_EQ(archive::begin_of(sidecar).source, ClockSource::container);
    sidecar.recorded = "soon";
    EXPECT_EQ(archive::begin_of(sidecar).utc, 0) << "no time before 1970";
    const std::vector<std::string> absurd_times{"2026-11-21 4294967295:00:00", "2026-11-21 25:00:00",
                                                "9999-11-21 08:00:07", "-026-11-21 08:00:07"};
    for (const std::string& absurd : absurd_times) {
        sidecar.recorded = absurd;
        EXPECT_EQ(archive::begin_of(sidecar).utc, 0) << absurd;
        EXPECT_EQ(archive::begin_of(sidecar).source, ClockSource::modified) << absurd;
    }
    archive::Sidecar failed = done("b.avi", {});
    failed.state = archive::Sidecar::State::failed;
    failed.reason = "<img src=x onerror=alert(1)>";
    const std::string text = archive::make_index({failed, sidecar});
    EXPECT_EQ(text, archive::make_index({failed, sidecar}));
    EXPECT_EQ(text.find("<img src=x"), std::string::npos);
    EXPECT_NE(text.find("./cam/a%3C/script%3E%22%FF.avi"), std::string::npos);
    EXPECT_NE(text.find("default-src 'none'; script-src 'sha256-"), std::string::npos);
    EXPECT_NO_THROW(archive::make_index({}));
}

TEST(FoundEvent, IsReadFromAReport) {
    const Json report = Json::parse(R"({"input": {"width": 200, "height": 100}, "events": [
        {"number": 3, "kind": "left", "stays": [{"seconds": 4.25}, {"seconds": 2}],
         "path": [{"seconds": 1.5, "place": {"x": 19.5, "y": 49.5}}, {"seconds": 9, "place": {"x": 19.5, "y": 49.5}}]}]})");
    const std::vector<archive::FoundEvent> found = archive::found_events(report);
    ASSERT_EQ(found.size(), 1U);
    // It stood for 6.25 s in all, as the picture, the page and the report say.
    EXPECT_EQ(found[0], (archive::FoundEvent{tracking::EventKind::left, 3, 63, {{15, 100, 500}, {90, 100, 500}}}));
    EXPECT_EQ(archive::json_of(found[0]).dump(), R"(["left",3,63,15,100,500,90,100,500])");
    EXPECT_EQ(archive::found_event_of(archive::json_of(found[0])), found[0]);
    EXPECT_THROW(archive::found_event_of(Json::parse(R"(["left", "x"])")), Json::exception);
    EXPECT_THROW(archive::found_events(Json::parse("{}")), Json::exception);
}

TEST(FoundEvent, OfEachKindStaysWhatItIs) {
    for (const tracking::EventKindRow& row : tracking::event_kinds) {
        const archive::FoundEvent event{row.kind, 1, 2, {{0, 1, 2}}};
        EXPECT_EQ(archive::found_event_of(archive::json_of(event)), event) << row.name;
    }
}

TEST(FoundEvent, KeepsItsClass) {
    const Json report = Json::parse(R"({"input": {"width": 200, "height": 100}, "events": [
        {"number": 1, "kind": "moved", "class": "dog", "stays": [], "path": [{"seconds": 1, "place": {"x": 0, "y": 0}}]},
        {"number": 2, "kind": "moved", "class": null, "stays": [], "path": []}]})");
    const std::vector<archive::FoundEvent> found = archive::found_events(report);
    ASSERT_EQ(found.size(), 2U);
    ASSERT_NE(found[0].what, nullptr);
    EXPECT_EQ(found[0].what->name, "dog");
    EXPECT_EQ(found[1].what, nullptr);
    EXPECT_EQ(archive::json_of(found[0]).back(), "dog");
    for (const archive::FoundEvent& event : found) {
        EXPECT_EQ(archive::found_event_of(archive::json_of(event)), event);
    }
    EXPECT_THROW(archive::found_event_of(Json::parse(R"(["left", 1, 2, 0, 1, 2, "ghost"])")), Error);
    Json other = report;
    other["events"][0]["class"] = "ghost";
    EXPECT_THROW(archive::found_events(other), Error);
}

TEST(FoundEvent, OfAnUnknownKindIsNone) {
    for (const char* name : {"flew", "x", "", "ms", "<b>"}) {
        EXPECT_THROW(archive::found_event_of(Json{name, 1, 2}), Error) << name;
    }
    const Json report = Json::parse(R"({"input": {"width": 200, "height": 100},
        "events": [{"number": 1, "kind": "l", "stays": [], "path": []}]})");
    EXPECT_THROW(archive::found_events(report), Error) << "reports have never had letters";

    archive::Sidecar sidecar;
    sidecar.clip = {"cam/a.avi", 1, 0};
    sidecar.found = {{tracking::EventKind::left, 1, 0, {{0, 1, 2}}}};
    std::string text = archive::format_sidecar(sidecar);
    EXPECT_TRUE(archive::parse_sidecar(text));
    text.replace(text.find("\"left\""), 6, "\"flew\"");
    EXPECT_FALSE(archive::parse_sidecar(text)) << "its clip is new, and drawn again";
}

TEST(FoundEvent, IsDroppedWhereThereAreTooMany) {
    Json report = Json::parse(R"({"input": {"width": 100, "height": 100}, "events": []})");
    for (int k = 1; k <= 5; ++k) {
        Json event =
            Json::parse(R"({"kind": "moved", "stays": [], "path": [{"seconds": 0, "place": {"x": 1, "y": 1}}]})");
        event["number"] = k;
        event["path"].push_back({{"seconds", k == 2 ? 100 : k}, {"place", {{"x", 50}, {"y", 50}}}});
        report["events"].push_back(event);
    }
    const std::vector<archive::FoundEvent> found = archive::found_events(report, 2);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].number, 2);
    EXPECT_EQ(found[1].number, 5);
}

TEST(DayFiles, HoldTheEventsOfADayAndNoMarkup) {
    archive::Sidecar sidecar;
    sidecar.clip = {"cam/</script><b>.avi", 1, 0};
    sidecar.recorded = "2026-11-21 08:00:07";
    sidecar.found = {{tracking::EventKind::left, 1, 0, {{0, 1, 2}, {10, 1, 2}}}};
    archive::Sidecar other = sidecar;
    other.recorded = "2026-11-20 10:00:00";
    other.stills = {4, 12};
    const archive::DayFiles days = archive::make_day_files({sidecar, other});
    ASSERT_EQ(days.size(), 2U);
    const std::string& text = days.at("index.2026-11-21.js");
    EXPECT_EQ(text.find('<'), std::string::npos);
    EXPECT_TRUE(text.starts_with("vvrDay(\"2026-11-21\",[[\"./cam/%3C"));
    EXPECT_NE(text.find(R"([["left",1,0,0,1,2,10,1,2]])"), std::string::npos);
    EXPECT_NE(days.at("index.2026-11-20.js").find("],[4,12]]"), std::string::npos) << "times of the contact sheet";
    for (const auto& [name, unused] : days) EXPECT_TRUE(archive::is_day_file(name));
    for (const char* name : {"index.html", "index.js", "index.2026-11-2.js", "index.2026x11-21.js",
                             "xindex.2026-11-21.js", "index.2026-11-21.js.bak", "index..js"}) {
        EXPECT_FALSE(archive::is_day_file(name)) << name;
    }
}

}  // namespace
}  // namespace vvr
