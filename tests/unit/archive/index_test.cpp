#include "core/archive/index.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/archive/sidecar.h"
#include "core/video/recorder_names.h"
#include "tests/unit/archive/archive.h"

namespace vvr {
namespace {

using test::Archive;

TEST_F(Archive, IndexesAnyTimesWithoutCountingDays) {
    ::setenv("TZ", "Europe/Berlin", 1);
    ::tzset();
    archive::Sidecar early = done("a.avi");
    archive::Sidecar late = done("b.avi");
    late.clip.modified = std::int64_t{7'258'000'000} * 1'000'000'000;
    const std::string text = archive::make_index({early, late});
    EXPECT_NE(text.find(R"("zone":[[1,3600,"CET, UTC+1"],[7258000000,3600,"CET, UTC+1"]])"), std::string::npos);
    ::setenv("TZ", "UTC", 1);
    ::tzset();
}

TEST_F(Archive, TakesCameraAndTimeFromNamesFirst) {
    ::setenv("TZ", "Europe/Berlin", 1);
    ::tzset();
    archive::Sidecar sidecar = done("2026-11-21/07/gate/00.07.mp4");
    sidecar.recorded = "2020-01-01 00:00:00";
    EXPECT_EQ(archive::begin_of(sidecar).utc, 1795244407) << "Frigate's are in UTC";
    const std::vector<std::string> local{"%Y-%m-%d/%H/{camera}/%M.%S"};
    EXPECT_EQ(archive::begin_of(sidecar, video::RecorderNames(local)).utc, 1795244407 - 3600);
    const std::string text = archive::make_index({sidecar, done("2026-03-29/00/hall/59.00.mp4")});
    EXPECT_NE(text.find(R"("cameras":["gate","hall"])"), std::string::npos);
    EXPECT_NE(text.find(R"("zone":[[1774745940,3600,"CET, UTC+1"],[1774746000,7200,"CEST, UTC+2"],)"
                        R"([1792890000,3600,"CET, UTC+1"]])"),
              std::string::npos);
    ::setenv("TZ", "UTC", 1);
    ::tzset();
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

}  // namespace
}  // namespace vvr
