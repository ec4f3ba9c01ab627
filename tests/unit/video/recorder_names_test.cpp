#include "core/video/recorder_names.h"

#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"

namespace vvr {
namespace {

constexpr std::int64_t morning = 1795248007;  // 2026-11-21 08:00:07

struct Known {
    const char* path;
    const char* layout;
    const char* camera;
    std::int64_t clock;
    std::optional<std::int64_t> ahead{};
};

TEST(RecorderNames, OfKnownRecordersTellCameraAndTime) {
    const RecorderNames names;
    for (const Known& known : {
             Known{"2026-11-21/08/gate/00.07.mp4", "Frigate", "gate", morning, 0},
             Known{"media/recordings/2026-11-21/08/front door/00.07.mp4", "Frigate", "front door", morning, 0},
             Known{"2026-11/21/08/gate/00.07.mp4", "Frigate", "gate", morning},
             Known{"RLC-823A_00_20261121080007.mp4", "Reolink", "RLC-823A", morning},
             Known{"2026/11/21/Back_yard_01_20261121080007.mp4", "Reolink", "Back_yard", morning},
             Known{"Mp4Record/2026-11-21/RecM01_20261121_080007_080107_6D28808_1E7A0B2.mp4", "Reolink", "Mp4Record",
                   morning},
             Known{"yard/RecM02_DST20261121_080007_080107_0_1E7A0B2.mp4", "Reolink", "yard", morning},
             Known{"192.168.1.64_01_20261121080007123.mp4", "Hikvision", "192.168.1.64", morning},
             Known{"Camera1_hiknvr_20261121080007_20261121081007_55.mp4", "Hikvision", "Camera1", morning},
             Known{"gate/2026-11-21/001/dav/08/08.00.07-08.01.07[M][0@0][0].dav", "Dahua", "gate", morning},
             Known{"NVR_ch2_main_20261121080007_20261121081007.dav", "Dahua", "NVR_ch2", morning},
             Known{"Cam1.20261121_080007.mp4", "Blue Iris", "Cam1", morning},
             Known{"Front Door 11-21-2026, 8.00.07 GMT+1 - 11-21-2026, 9.00.00 GMT+1.mp4", "UniFi", "Front Door",
                   morning, 3600},
             Known{"Front Door 11-21-2026, 08.00.07.mp4", "UniFi", "Front Door", morning},
             Known{"gate/01-20261121080007.mkv", "motion", "gate", morning},
             Known{"Camera1/2026-11-21/08-00-07.mp4", "motion", "Camera1", morning},
             Known{"gate/2026-11-21T08:00:07Z.mp4", "ISO 8601", "gate", morning, 0},
             Known{"gate/2026-11-21T08-00-07+05:30.mp4", "ISO 8601", "gate", morning, 19800},
             Known{"gate/20261121T080007-0330.mp4", "ISO 8601", "gate", morning, -12600},
             Known{"gate/2026-11-21_08-00-07-123456.mp4", "ISO 8601", "gate", morning},
             Known{"gate/clip 2026-11-21 08.00.07.mp4", "ISO 8601", "gate", morning},
             Known{"gate/VID_20261121_080007.mp4", "ISO 8601", "gate", morning},
             Known{"hall-20261121080007", "ISO 8601", "", morning},
         }) {
        const RecorderName name = names.read(known.path);
        EXPECT_EQ(name.layout, known.layout) << known.path;
        EXPECT_EQ(names.camera_of(known.path), known.camera) << known.path;
        ASSERT_TRUE(name.begin) << known.path;
        EXPECT_EQ(name.begin->clock, known.clock) << known.path;
        EXPECT_EQ(name.begin->ahead, known.ahead) << known.path;
    }
}

TEST(RecorderNames, OfNobodyTellNothing) {
    const RecorderNames names;
    for (const char* path : {"x.avi", "", "/", "....", "gate/clip 12.mp4", "2026-11-21/25/gate/00.07.mp4",
                             "gate/20260231080007.mp4", "gate/2026-13-21_08-00-07.mp4", "gate/123456789012345.mp4"}) {
        EXPECT_EQ(names.read(path).layout, "") << path;
        EXPECT_FALSE(names.read(path).begin) << path;
    }
}

TEST(RecorderNames, AreThoseOfTheUserFirst) {
    const RecorderNames names(std::vector<std::string>{"%Y-%m-%d/%H/{camera}/%M.%S", "{camera} at %s", "cam {camera}"});
    const RecorderName local = names.read("2026-11-21/08/gate/00.07.mp4");
    EXPECT_EQ(local.layout, "--names");
    EXPECT_EQ(local.begin, (NamedTime{morning, {}})) << "not in UTC, unlike Frigate's";
    EXPECT_EQ(names.read("hall at 1795248007.mp4").begin, (NamedTime{morning, 0}));
    EXPECT_EQ(names.camera_of("x/cam 7.mp4"), "7");
    // The camera by one pattern, the time by a known one.
    const RecorderName both = names.read("cam 20261121_080007.mp4");
    EXPECT_EQ(both.camera, "20261121_080007");
    EXPECT_EQ(both.begin, (NamedTime{morning, {}}));
}

TEST(RecorderNames, RefuseWrongPatterns) {
    const auto refusal = [](const std::string& pattern) -> std::string {
        try {
            RecorderLayout("--names", pattern);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
            return error.what();
        }
        return "";
    };
    EXPECT_NE(refusal("%Y-%q").find("'%q'"), std::string::npos);
    EXPECT_NE(refusal("{cam}_%s").find("'{cam}'"), std::string::npos);
    EXPECT_NE(refusal("{cam").find("'{cam'"), std::string::npos);
    EXPECT_NE(refusal("%").find("'%'"), std::string::npos);
    EXPECT_NE(refusal("%Y-%m-%d").find("%Y, %m, %d and %H"), std::string::npos);
    EXPECT_NE(refusal("clip*").find("neither {camera} nor a time"), std::string::npos);
    EXPECT_NE(refusal("").find("0 bytes"), std::string::npos);
    EXPECT_NE(refusal(std::string(300, '*')).find("300 bytes"), std::string::npos);
    EXPECT_EQ(refusal("100%% {camera}"), "");
}

TEST(RecorderNames, OfAnyBytesAreReadSoon) {
    const RecorderNames names(std::vector<std::string>{"*{camera}*a*a*a*a*%Y*%m*%d*%H*b", "{camera}%Y%m%d%H*c"});
    const auto begin = std::chrono::steady_clock::now();
    for (const char c : {'a', '0', '1', '_', '\xFF', '\0', '/', '.'}) names.read(std::string(255, c));
    for (const std::size_t length : {4096, 4097, 1'000'000}) names.read(std::string(length, '1') + ".mp4");
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(took.count(), 5);
    EXPECT_EQ(names.camera_of("../../2026-11-21/08/../00.07.mp4"), "..") << "a text, followed by nobody";
}

TEST(RecorderNames, AreOnTheLocalClockAcrossSummerTime) {
    ::setenv("TZ", "Europe/Berlin", 1);
    ::tzset();
    const RecorderNames names;
    const auto utc = [&](const std::string& clock, std::optional<std::int64_t> near = {}) {
        return utc_of(*names.read("gate/" + clock + ".mp4").begin, near);
    };
    EXPECT_EQ(utc("20261121080007"), morning - 3600);
    EXPECT_EQ(utc("20260329030000") - utc("20260329015950"), 10) << "clocks leap from 2:00 to 3:00";
    EXPECT_EQ(utc("20260329023000"), utc("20260329033000")) << "no clock shows it";
    const std::int64_t first = utc("20261025023000");
    EXPECT_EQ(utc("20261025023000", first + 3000), first + 3600) << "2:30 comes twice";
    EXPECT_EQ(utc("20261025023000", first + 10), first);
    ::setenv("TZ", "UTC", 1);
    ::tzset();
    EXPECT_EQ(utc("20261121080007"), morning);
}

}  // namespace
}  // namespace vvr
