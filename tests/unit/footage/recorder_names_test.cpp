#include "core/footage/recorder_names.h"

#include <chrono>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/errors.h"
#include "tests/support/zone.h"

namespace vvr {
namespace {

constexpr const char* any_name = "a date and a time";
constexpr std::int64_t morning = 1795248007;  // 2026-11-21 08:00:07

struct Known {
    const char* path;
    const char* layout;
    const char* camera;
    std::int64_t clock;
    std::optional<std::int64_t> ahead{};
};

TEST(RecorderNames, OfKnownRecordersTellCameraAndTime) {
    const footage::RecorderNames names;
    for (const Known& known : {
             Known{"2026-11-21/08/gate/00.07.mp4", "Frigate", "gate", morning, 0},
             Known{"media/recordings/2026-11-21/08/front door/00.07.mp4", "Frigate", "front door", morning, 0},
             Known{"2026-11/21/08/gate/00.07.mp4", "Frigate", "gate", morning},
             Known{"RLC-823A_00_20261121080007.mp4", "Reolink", "RLC-823A", morning},
             Known{"2026/11/21/Back_yard_01_20261121080007.mp4", any_name, "Back_yard_01", morning},
             Known{"Mp4Record/2026-11-21/RecM01_20261121_080007_080107_6D28808_1E7A0B2.mp4", "Reolink", "Mp4Record",
                   morning},
             Known{"yard/RecM02_DST20261121_080007_080107_0_1E7A0B2.mp4", "Reolink", "yard", morning},
             Known{"192.168.1.64_01_20261121080007123.mp4", "Hikvision", "192.168.1.64_01", morning},
             Known{"Camera1_hiknvr_20261121080007_20261121081007_55.mp4", "Hikvision", "Camera1", morning},
             Known{"gate/2026-11-21/001/dav/08/08.00.07-08.01.07[M][0@0][0].dav", "Dahua", "gate", morning},
             Known{"NVR_ch2_main_20261121080007_20261121081007.dav", "Dahua", "NVR_ch2", morning},
             Known{"Cam1.20261121_080007.mp4", "Blue Iris", "Cam1", morning},
             Known{"Front Door 11-21-2026, 8.00.07 GMT+1 - 11-21-2026, 9.00.00 GMT+1.mp4", "UniFi", "Front Door",
                   morning, 3600},
             Known{"Front Door 11-21-2026, 08.00.07.mp4", "UniFi", "Front Door", morning},
             Known{"gate/01-20261121080007.mkv", "motion", "gate", morning},
             Known{"Camera1/2026-11-21/08-00-07.mp4", "motion", "Camera1", morning},
             Known{"gate/2026-11-21T08:00:07Z.mp4", any_name, "gate", morning, 0},
             Known{"gate/2026-11-21T08-00-07+05:30.mp4", any_name, "gate", morning, 19800},
             Known{"gate/20261121T080007-0330.mp4", any_name, "gate", morning, -12600},
             Known{"gate/2026-11-21_08-00-07-123456.mp4", any_name, "gate", morning},
             Known{"gate/clip 2026-11-21 08.00.07.mp4", any_name, "gate", morning},
             Known{"gate/VID_20261121_080007.mp4", any_name, "gate", morning},
             Known{"hall-20261121080007", any_name, "hall", morning},
         }) {
        const footage::RecorderName name = names.read(known.path);
        EXPECT_EQ(name.scheme, known.layout) << known.path;
        EXPECT_EQ(names.camera_of(known.path), known.camera) << known.path;
        ASSERT_TRUE(name.begin) << known.path;
        EXPECT_EQ(name.begin->clock, known.clock) << known.path;
        EXPECT_EQ(name.begin->ahead, known.ahead) << known.path;
    }
}

TEST(RecorderNames, OfPlainTreesTellCameraAndTime) {
    const footage::RecorderNames names;
    constexpr std::int64_t evening = 1795291200;  // 2026-11-21 20:00:00
    struct Tree {
        const char* path;
        const char* camera;
        std::int64_t clock = evening;
        std::optional<std::int64_t> ahead{};
    };
    for (const Tree& tree : {
             // The date as a folder.
             Tree{"2026-11-21/gate/20-00-00.mp4", "gate"},
             Tree{"gate/2026-11-21/20.00.00.mp4", "gate"},
             Tree{"gate/2026/11/21/20-00-00.mp4", "gate"},
             Tree{"gate/20261121/20/00.mp4", "gate"},
             Tree{"gate/2026-11-21/20-00-00_20-05-00.mp4", "gate"},
             Tree{"2026-11-21/20/gate/05.00.mp4", "gate", evening + 300, 0},
             Tree{"2026_11_21/20/gate/05.00.mp4", "gate", evening + 300},
             Tree{"gate/2026.11.21/200000.mp4", "gate"},
             Tree{"gate/2026-11-21/2000.mp4", "gate"},
             Tree{"gate/2026-11-21/20-00.mp4", "gate"},
             Tree{"gate/2026-11/21/20h00m00s.mp4", "gate"},
             Tree{"gate/2026/11-21/20_00_00.mp4", "gate"},
             Tree{"gate/2026/2026-11/2026-11-21/20:00:00.mp4", "gate"},
             Tree{"gate/2026-11-21/20/20-00-00.mp4", "gate"},
             Tree{"gate/2026-11-21/20/05-00.mp4", "gate", evening + 300},
             Tree{"gate/2026-11-21/20h/05.mp4", "gate", evening + 300},
             Tree{"2026-11-21/gate/20/05.mp4", "gate", evening + 300},
             Tree{"2026-11-21/20/gate/05.mp4", "gate", evening + 300},
             Tree{"2026-11-21/01/20-00-00.mp4", "01"},
             Tree{"2026-11-21/gate_20-00-00.mp4", "gate"},
             Tree{"2026/11/21/gate/20-00_20-05.mp4", "gate"},
             Tree{"2026-11-21/20-00-00 motion.mp4", ""},
             Tree{"2026-11-21/20-00-00-front.mp4", "front"},
             Tree{"gate/2026-11-21_20/05-00.mp4", "gate", evening + 300},
             Tree{"gate/2026-11-21_20/05.mp4", "gate", evening + 300},
             // All in the name.
             Tree{"front-door_2026-11-21_20-00-00.mp4", "front-door"},
             Tree{"house/front-door_2026-11-21_20-00-00.mp4", "house/front-door"},
             Tree{"gate/gate_2026-11-21_20-00-00.mp4", "gate"},
             Tree{"recordings/gate_2026-11-21_20-00-00.mp4", "gate"},
             Tree{"ch01_20261121200000.mp4", "ch01"},
             Tree{"192.168.1.10_01_2026-11-21_20-00-00.mp4", "192.168.1.10_01"},
             Tree{"192.168.1.10_2026-11-21_20-00-00.mp4", "192.168.1.10"},
             Tree{"ch01_20261121-200000_200500.mp4", "ch01"},
             Tree{"CAM 2 - 2026.11.21 20.00.00.mp4", "CAM 2"},
             Tree{"cam-2-20261121_2000.mp4", "cam-2"},
             Tree{"gate_2026-11-21_20-00.mp4", "gate"},
             Tree{"gate_2026-11-21_20-00-00_2026-11-21_20-05-00.mp4", "gate"},
             Tree{"2026-11-21_20-00-00.000.mp4", ""},
             Tree{"2026-11-21 20.00.00", ""},
             Tree{"2026-11-21_20-00-00-1.mp4", ""},
             Tree{"2026-11-21T20:00:00+05:30_gate.mp4", "", evening, 19800},
             Tree{"gate_2026-11-21T20-00-00Z.mp4", "gate", evening, 0},
             Tree{"2026-11-21_20-00-00-left_repeater.mp4", "left_repeater"},
             Tree{"20261121_200000_cam2.mp4", "cam2"},
             Tree{"VID_20261121_200000.mp4", ""},
             Tree{"PXL_20261121_200000123.mp4", ""},
             Tree{"clip 7 2026-11-21 20-00-00.mp4", ""},
             Tree{"MDalarm_20261121_200000.mkv", ""},
             Tree{"Screen Recording 2026-11-21 at 20.00.00.mov", ""},
             Tree{"1795291200.mp4", "", evening, 0},
             Tree{"1795291200000.mp4", "", evening, 0},
             Tree{"gate/1795291200_1795291500.mp4", "gate", evening, 0},
             Tree{"gate-1795291200.mp4", "gate", evening, 0},
             // Of recorders.
             Tree{"NVR/2026-11-21/001/dav/20/20.00.00-20.05.00[M][0@0][0].dav", "NVR"},
             Tree{"house/2026-11-21/002/dav/20/20.00.00-20.05.00[M][0@0][0].dav", "house/002"},
             Tree{"gate/2026-11-21/20.00.00-20.00.20[M][0@0][0].dav", "gate"},
             Tree{"gate-20261121-200000-1795291200.mp4", "gate"},
             Tree{"20261121PM/Front Door-20261121-200000-1795291200123-7.mp4", "Front Door"},
             Tree{"gate-1795291200.123456-ab12cd.mp4", "gate", evening, 0},
             Tree{"events/3/26/11/21/20/00/00/17-video.mp4", "3"},
             Tree{"2026112120/05M00S_1795291500.mp4", "", evening + 300, 0},
             Tree{"gate/2026Y11M21D20H/05M00S60.mp4", "gate", evening + 300},
             Tree{"Front Door 3-4-2026, 20.00.00 GMT+1.mp4", "Front Door", 1772654400, 3600},
         }) {
        const footage::RecorderName name = names.read(tree.path);
        EXPECT_EQ(names.camera_of(tree.path), tree.camera) << tree.path;
        ASSERT_TRUE(name.begin) << tree.path;
        EXPECT_EQ(name.begin->clock, tree.clock) << tree.path << " by " << name.scheme;
        EXPECT_EQ(name.begin->ahead, tree.ahead) << tree.path << " by " << name.scheme;
    }
}

TEST(RecorderNames, OfTwelveHoursAndOfZonesAreRead) {
    const footage::RecorderNames names;
    constexpr std::int64_t day = 1795219200;  // 2026-11-21
    constexpr std::int64_t evening = day + 72000;
    struct Clock {
        const char* path;
        const char* camera;
        std::int64_t clock;
        std::optional<std::int64_t> ahead{};
    };
    for (const Clock& each : {
             Clock{"Front Door - 11-21-2026, 8.00.07pm.mp4", "Front Door", evening + 7},
             Clock{"Front Door - 11-21-2026, 12.05.40am.mp4", "Front Door", day + 340},
             Clock{"Front Door 11-21-2026, 12.05.40pm.mp4", "Front Door", day + 43200 + 340},
             Clock{"Front Door 11-21-2026, 8.00.07 PM GMT+1.mp4", "Front Door", evening + 7, 3600},
             Clock{"gate_2026-11-21_08-00-07PM.mp4", "gate", evening + 7},
             Clock{"gate_2026-11-21_08-00-07AM.mp4", "gate", morning},
             Clock{"2026-11-21 08-00-07 pm.mp4", "", evening + 7},
             Clock{"2026-11-21 8.00.07 p.m..mp4", "", evening + 7},
             Clock{"20261121_080007PM.mp4", "", evening + 7},
             Clock{"gate/2026-11-21/08-00-07 PM.mp4", "gate", evening + 7},
             Clock{"Cam1.20261121_080007PM.mp4", "Cam1", evening + 7},
             Clock{"2026-11-21 08-00-07 America.mp4", "", morning},
             Clock{"gate_2026-11-21_08-00-07_UTC.mp4", "gate", morning, 0},
             Clock{"gate_2026-11-21_08-00-07 GMT+1.mp4", "gate", morning, 3600},
             Clock{"gate_2026-11-21_08-00-07PM_UTC.mp4", "gate", evening + 7, 0},
             Clock{"2026-11-21T08_00_07+00_00.mp4", "", morning, 0},
             Clock{"2026-11-21T08_00_07-05_00.mp4", "", morning, -18000},
             Clock{"2026-11-21T08-00-07Z.mp4", "", morning, 0},
             Clock{"gate/2026-11-21/08-00-07Z.mp4", "gate", morning, 0},
             Clock{"2026-11-21_08_00_07-09_00_00.mp4", "", morning},
             // Of two times the first is the begin.
             Clock{"cam(20261121200000-20261121210000).mp4", "cam", evening},
             Clock{"cam20261121200000-20261121210000.mp4", "", evening},
             Clock{"gate [2026-11-21 20-00-00]-[2026-11-21 21-00-00].mp4", "gate", evening},
             Clock{"gate (2026-11-21 20-00-00 to 2026-11-21 21-00-00).mp4", "gate", evening},
             Clock{"in_progress.front_door@2026_11_21_20_00__2026_11_21_21_00.mp4", "front_door", evening},
             Clock{"front_door@2026_11_21_20_00__2026_11_21_21_00.mp4", "front_door", evening},
             // Two cameras of a car, and the folders of a card.
             Clock{"dash/20261121_080007F.MP4", "dash/F", morning},
             Clock{"dash/20261121_080007R.MP4", "dash/R", morning},
             Clock{"20261121_080007_NF.mp4", "F", morning},
             Clock{"20261121_080007_ER.mp4", "R", morning},
             Clock{"cards/A01/101EK113/20261121_080007.MP4", "cards/A01", morning},
         }) {
        const footage::RecorderName name = names.read(each.path);
        EXPECT_EQ(names.camera_of(each.path), each.camera) << each.path;
        ASSERT_TRUE(name.begin) << each.path << " by " << name.scheme;
        EXPECT_EQ(name.begin->clock, each.clock) << each.path << " by " << name.scheme;
        EXPECT_EQ(name.begin->ahead, each.ahead) << each.path << " by " << name.scheme;
    }
    for (const char* path :
         {"gate_2026-11-21_08-00-07_EST.mp4", "2026-11-21 08.00.07 CEST.mp4", "gate/2026-11-21/08-00-07 MSK.mp4",
          "gate_00_20261121080007 EST.mp4", "Rec01_20261121_080007_EST_1.mp4", "gate-20261121-080007-EST-7.mp4"}) {
        EXPECT_FALSE(names.read(path).begin) << path;
    }
    EXPECT_EQ(names.camera_of("cards/A01/100EK113/IMAG0001.MP4"), "cards/A01");
    EXPECT_EQ(names.camera_of("DCIM/100MEDIA/IMAG0001.MP4"), "");
    EXPECT_TRUE(names.read("yard/RecS02_20261121_080007_080107_0.mp4").sub);
    EXPECT_FALSE(names.read("yard/RecM02_20261121_080007_080107_0.mp4").sub);
}

TEST(RecorderNames, OfAFolderTellWhichIsTheMonth) {
    const std::vector<std::string> files{"unifi/Front Door - 2-9-2026, 11.21.12pm.mp4",
                                         "unifi/Front Door - 2-19-2026, 1.05.40pm.mp4",
                                         "other/Front Door - 2-9-2026, 11.21.12pm.mp4"};
    footage::RecorderNames names;
    EXPECT_TRUE(names.read(files[0]).ambiguous);
    names.compare(files);
    EXPECT_EQ(names.read(files[0]).begin, (footage::NamedTime{1770679272, {}}));
    EXPECT_TRUE(names.read(files[1]).begin);
    EXPECT_TRUE(names.read(files[2]).ambiguous) << "nothing in its folder tells";
}

TEST(RecorderNames, NumbersAreCamerasWhereFilesShowIt) {
    const auto cameras_of = [](const std::vector<std::string>& paths) {
        footage::RecorderNames names;
        names.compare(paths);
        std::vector<std::string> cameras;
        for (const std::string& path : paths) cameras.push_back(names.camera_of(path));
        return cameras;
    };
    // Several files of one number, at different times.
    EXPECT_EQ(cameras_of({"video1_20261121_200000.mp4", "video1_20261121_201000.mp4", "video2_20261121_200300.mp4",
                          "video2_20261121_201300.mp4"}),
              (std::vector<std::string>{"video1", "video1", "video2", "video2"}));
    EXPECT_EQ(cameras_of({"in/01_20261121200000.mp4", "in/02_20261121200001.mp4"}),
              (std::vector<std::string>{"in/01", "in/02"}));
    EXPECT_EQ(cameras_of({"2026-11-21/Rec_1_20-00-00.mp4", "2026-11-22/Rec_1_20-00-00.mp4"}),
              (std::vector<std::string>{"Rec_1", "Rec_1"}));
    EXPECT_EQ(cameras_of({"01_20261121200000.mp4", "01_20261121200500.mp4", "02_20261121200200.mp4"}),
              (std::vector<std::string>{"01", "01", "02"}));
    // A number per file, one after another, counts them.
    EXPECT_EQ(cameras_of({"clip1_20261121_200000.mp4", "clip2_20261121_201000.mp4", "clip3_20261121_202000.mp4"}),
              (std::vector<std::string>{"", "", ""}));
    footage::RecorderNames described;
    described.describe_camera("01", {});
    EXPECT_EQ(described.camera_of("01_20261121200000.mp4"), "01");
    EXPECT_EQ(described.camera_of("02_20261121200000.mp4"), "");
    // Files of two folders at the same time are not files of two numbers.
    EXPECT_EQ(cameras_of({"gate/clip1_20261121_200000.mp4", "yard/clip1_20261121_200000.mp4"}),
              (std::vector<std::string>{"gate", "yard"}));
}

TEST(RecorderNames, AreNotGuessed) {
    const footage::RecorderNames names;
    for (const char* path :
         {"gate/clip1.mp4", "2026-11-21/clip1.mp4", "gate/1280x720_30fps.mp4", "2026-11-21/1280x720_30fps.mp4",
          "gate/IMG_0001.mp4", "2026-11-21/IMG_0001.mp4", "2026-11-21/IMG_000123.mp4", "v1.20.30.mp4",
          "gate/20.04.1.mp4", "2026-11-21/20.04.1.mp4", "20-00-00.mp4", "gate/2000.mp4", "2026/2000.mp4",
          "2026-11-21.mp4", "gate_2026-11-21_20.mp4", "2026-11-21_20-00-75.mp4", "2026-11-21/24-00-00.mp4",

          // Which is the month?
          "03-04-2026_20-00-00.mp4", "gate_03.04.2026 20.00.00.mp4", "03-04-2026/gate/20-00-00.mp4",
          "01-02-2026-03-04-05-06.mp4", "Front Door 3-4-2026, 20.00.00.mp4", "21-11-2026 20-00-00.mp4",
          // 20:05, or 20:20:05?
          "2026_11_21/20/20-05.mp4", "WhatsApp Video 2026-11-21 at 20.00.00.mp4", "12345678.mp4", "0912345678.mp4",
          "5912345678.mp4"}) {
        const footage::RecorderName name = names.read(path);
        EXPECT_FALSE(name.begin) << path << " by " << name.scheme;
    }
    EXPECT_EQ(names.camera_of("2026-11-21/backdoor/clip1.mp4"), "backdoor");
}

TEST(RecorderNames, SayTheSameWhereverOneStands) {
    const footage::RecorderNames whole;
    const std::string path = "/srv/2026-11-21/20/gate/05.00.mp4";
    for (const char* folder : {"/", "/srv", "/srv/2026-11-21", "/srv/2026-11-21/20", "/srv/2026-11-21/20/gate"}) {
        const footage::RecorderNames names({}, folder);
        const std::string below = path.substr(std::string(folder).size() + (std::string(folder) == "/" ? 0 : 1));
        EXPECT_EQ(names.read(below).begin, whole.read(path).begin) << folder;
        EXPECT_EQ(names.camera_of(below), "gate") << folder;
    }
    // Folders above the archive's are no cameras.
    EXPECT_EQ(footage::RecorderNames({}, "/home/user/videos").camera_of("x.avi"), "");
    EXPECT_EQ(footage::RecorderNames({}, "/home/user/2026-11-21").camera_of("20-00-00.avi"), "");
}

TEST(RecorderNames, OfNobodyTellNothing) {
    const footage::RecorderNames names;
    for (const char* path : {"x.avi", "", "/", "....", "gate/clip 12.mp4", "2026-11-21/25/gate/00.07.mp4",
                             "gate/20260231080007.mp4", "gate/2026-13-21_08-00-07.mp4", "gate/123456789012345.mp4"}) {
        EXPECT_EQ(names.read(path).scheme, "") << path;
        EXPECT_FALSE(names.read(path).begin) << path;
    }
}

TEST(RecorderNames, AreThoseOfTheUserFirst) {
    const footage::RecorderNames names(
        std::vector<std::string>{"%Y-%m-%d/%H/{camera}/%M.%S", "{camera} at %s", "cam {camera}"});
    const footage::RecorderName local = names.read("2026-11-21/08/gate/00.07.mp4");
    EXPECT_EQ(local.scheme, "--names");
    EXPECT_EQ(local.begin, (footage::NamedTime{morning, {}})) << "not in UTC, unlike Frigate's";
    EXPECT_EQ(names.read("hall at 1795248007.mp4").begin, (footage::NamedTime{morning, 0}));
    EXPECT_EQ(names.camera_of("x/cam 7.mp4"), "7");
    const footage::RecorderNames noon(std::vector<std::string>{"{camera} %b %-d %Y %-I.%M%p%z"});
    EXPECT_EQ(noon.read("hall Nov 21 2026 9.00pmGMT+1.mp4").begin, (footage::NamedTime{1795294800, 3600}));
    // The camera by one pattern, the time by a known one.
    const footage::RecorderName both = names.read("cam 20261121_080007.mp4");
    EXPECT_EQ(both.camera, "20261121_080007");
    EXPECT_EQ(both.begin, (footage::NamedTime{morning, {}}));
}

TEST(RecorderNames, RefuseWrongPatterns) {
    const std::pair<std::string, const char*> patterns[] = {
        {"%Y-%q", "'%q'"},     {"{cam}_%s", "'{cam}'"}, {"{cam", "'{cam'"},
        {"%", "'%'"},          {"%Y-%m-%d", "%H"},      {"%Y-%m-%d %I", "%p"},
        {"clip*", "{camera}"}, {"", "0 bytes"},         {std::string(300, '*'), "300 bytes"}};
    for (const auto& [pattern, fact] : patterns) {
        test::expect_error(ErrorCode::name_pattern_invalid,
                           [&pattern = pattern] { footage::RecorderNames(std::vector<std::string>{pattern}); }, {fact});
    }
    EXPECT_NO_THROW(footage::RecorderNames(std::vector<std::string>{"100%% {camera}"}));
}

TEST(RecorderNames, OfAnyBytesAreReadSoon) {
    const footage::RecorderNames names(
        std::vector<std::string>{"*{camera}*a*a*a*a*%Y*%m*%d*%H*b", "{camera}%Y%m%d%H*c"});
    const auto begin = std::chrono::steady_clock::now();
    for (const char c : {'a', '0', '1', '_', '\xFF', '\0', '/', '.'}) names.read(std::string(255, c));
    for (const std::size_t length : {4096U, 4097U, 1'000'000U}) names.read(std::string(length, '1') + ".mp4");
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(took.count(), 5);
    EXPECT_EQ(names.camera_of("../../2026-11-21/08/../00.07.mp4"), "..") << "a text, followed by nobody";
}

TEST(RecorderNames, AreOnTheLocalClockAcrossSummerTime) {
    const footage::RecorderNames names;
    const auto utc = [&](const std::string& clock, std::optional<std::int64_t> near = {}) {
        return footage::utc_of(*names.read("gate/" + clock + ".mp4").begin, near);
    };
    EXPECT_EQ(utc("20261121080007"), morning);
    const test::InZone berlin("Europe/Berlin");
    EXPECT_EQ(utc("20261121080007"), morning - 3600);
    EXPECT_EQ(utc("20260329030000") - utc("20260329015950"), 10) << "clocks leap from 2:00 to 3:00";
    EXPECT_EQ(utc("20260329023000"), utc("20260329033000")) << "no clock shows it";
    const std::int64_t first = utc("20261025023000");
    EXPECT_EQ(utc("20261025023000", first + 3000), first + 3600) << "2:30 comes twice";
    EXPECT_EQ(utc("20261025023000", first + 10), first);
}

}  // namespace
}  // namespace vvr
