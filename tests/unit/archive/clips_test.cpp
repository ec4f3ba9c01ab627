#include "core/archive/clips.h"

#include <atomic>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <sys/stat.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/archive/camera_days.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/footage/input_files.h"
#include "core/footage/recorder_names.h"
#include "tests/support/zone.h"
#include "tests/unit/archive/archive.h"

namespace vvr {
namespace {

namespace fs = std::filesystem;
using test::Archive;

TEST_F(Archive, HasNoProblemWithClipsThatAreDeletedMeanwhile) {
    constexpr int many = 200;
    const auto name = [](int k) { return fmt::format("{:03}", k); };
    for (int k = 0; k < many; ++k) {
        write(in() / (name(k) + ".avi"));
        write(in() / name(k) / "clip.avi");
    }
    std::atomic<bool> ended = false;
    const std::jthread recorder([&] {
        // In the other order than the scan, so that they meet.
        for (int k = many; k-- > 0;) {
            fs::remove(in() / (name(k) + ".avi"));
            fs::remove_all(in() / name(k));
        }
        ended = true;
    });
    while (!ended) {
        const archive::Scan scan = archive::scan_archive(in(), out(), archive::ClipNames());
        EXPECT_TRUE(scan.problems.empty()) << scan.problems.front().path << ": " << scan.problems.front().reason;
    }
    fs::create_symlink("nowhere", in() / "link.avi");
    EXPECT_EQ(archive::scan_archive(in(), out(), archive::ClipNames()).problems.size(), 1U);
}

TEST_F(Archive, SkipsWhatANasKeepsBetweenTheClips) {
    for (const char* name : {"gate/a.avi", "#recycle/gate/b.avi", "gate/@eaDir/a.avi/c.avi", "$Recycle.Bin/S-1/d.avi",
                             "@eaDir/note.txt", "recycle/e.avi"}) {
        write(in() / name);
    }
    const archive::Scan scan = archive::scan_archive(in(), out(), archive::ClipNames());
    EXPECT_EQ(found(), (std::vector<std::string>{"gate/a.avi", "recycle/e.avi"}));
    EXPECT_EQ(scan.skipped, 3U);
    EXPECT_EQ(scan.system_folders, (std::set<std::string>{"#recycle", "$Recycle.Bin", "gate/@eaDir"}));
    EXPECT_EQ(footage::video_files_in(in()).size(), 2U);
}

TEST_F(Archive, FindsClipsInFolders) {
    for (const char* name :
         {"a.avi", "cam/b.mp4", "cam/2026-11-21/c.mkv", "notes.txt", ".hidden.avi", ".trash/d.avi"}) {
        write(in() / name);
    }
    EXPECT_EQ(found(), (std::vector<std::string>{"a.avi", "cam/2026-11-21/c.mkv", "cam/b.mp4"}));
    EXPECT_EQ(found(archive::ClipNames({"*.txt"})), (std::vector<std::string>{"notes.txt"}));
    const archive::Clip clip = archive::scan_archive(in(), out(), archive::ClipNames()).clips.front();
    EXPECT_EQ(clip.size, 1);
    EXPECT_EQ(archive::stat_clip(in(), "a.avi")->modified, clip.modified);
    EXPECT_FALSE(archive::stat_clip(in(), "z.avi"));
}

TEST_F(Archive, FollowsEachFolderOnce) {
    write(in() / "cam/a.avi");
    write(in().parent_path() / "elsewhere/b.avi");
    fs::create_directory_symlink("..", in() / "cam/up");
    fs::create_directory_symlink("cam", in() / "a link that comes first");
    fs::create_directory_symlink("../elsewhere", in() / "away");
    fs::create_directory_symlink("../elsewhere", in() / "away again");
    fs::create_symlink("turn.avi", in() / "round.avi");
    fs::create_symlink("round.avi", in() / "turn.avi");
    fs::create_symlink("cam/a.avi", in() / "one.avi");
    EXPECT_EQ(found(), (std::vector<std::string>{"away/b.avi", "cam/a.avi", "one.avi"}));
    const archive::Scan scan = archive::scan_archive(in(), out(), archive::ClipNames());
    ASSERT_EQ(scan.problems.size(), 2);
    EXPECT_EQ(scan.problems[0].path, "round.avi");
}

TEST_F(Archive, NeverTakesItsOwnPicturesForClips) {
    const fs::path pictures = in() / "pictures";
    write(pictures / "cam/a.avi");
    write(in() / "b.avi");
    EXPECT_EQ(archive::scan_archive(in(), pictures, archive::ClipNames({"*"})).clips.size(), 1);
    EXPECT_THROW(archive::scan_archive(in(), in(), archive::ClipNames()), Error);
    EXPECT_THROW(archive::scan_archive(in() / "none", out(), archive::ClipNames()), Error);
    EXPECT_THROW(archive::scan_archive(in() / "b.avi", out(), archive::ClipNames()), Error);
}

TEST_F(Archive, TakesNoKeptPiecesForClips) {
    for (const char* name : {"kept/a.avi.events/event-1.mp4", "kept/a.avi.events/evidence.json", "b.events/b.avi"}) {
        write(in() / name);
    }
    EXPECT_EQ(found(), std::vector<std::string>{"b.events/b.avi"}) << "a folder that is only called so";
}

TEST_F(Archive, RefusesNamesWhoseFilesWouldClash) {
    for (const char* name : {"index", "a", "a.report", "b.avi", "b.mp4", "c", "c.png/d"}) write(in() / name);
    const archive::Scan scan = archive::scan_archive(in(), out(), archive::ClipNames({"*"}));
    std::set<std::string> refused;
    for (const archive::ScanProblem& problem : scan.problems) refused.insert(problem.path);
    EXPECT_EQ(refused, (std::set<std::string>{"index", "a.report", "c"}));
    EXPECT_EQ(scan.clips.size(), 4);
}

TEST(CameraDays, AreOfTheDayOnTheLocalWall) {
    const test::InZone berlin("Europe/Berlin");
    const std::vector<archive::Clip> clips{{"2026-11-21/22/gate/59.50.mp4", 5, 10},
                                           {"2026-11-21/23/gate/00.00.mp4", 7, 20},
                                           {"2026-11-21/23/gate/00.10.mp4", 9, 30},
                                           {"hall/x.mp4", 1, 20}};
    using std::chrono::nanoseconds;
    const std::chrono::system_clock::time_point now{nanoseconds(30)};
    const archive::CameraDays grouped = archive::group_by_day(clips, footage::RecorderNames(), {now, nanoseconds(10)});
    const auto& days = grouped.days;
    ASSERT_EQ(days.size(), 3U);
    EXPECT_EQ(days[0].clip.path, "gate/2026-11-21");
    EXPECT_EQ(days[1].clip.path, "gate/2026-11-22") << "Frigate's hour 23 is past midnight in Berlin";
    EXPECT_EQ(days[1].files.size(), 1U) << "the newest is still being written";
    EXPECT_EQ(grouped.waiting, 1U);
    EXPECT_EQ(days[2].clip.path, "hall/1970-01-01") << "by when it was written";
    EXPECT_TRUE(grouped.problems.empty());

    const std::chrono::system_clock::time_point before{nanoseconds(5)};
    const auto ahead = archive::group_by_day(clips, footage::RecorderNames(), {before, nanoseconds(2)}).days;
    EXPECT_EQ(ahead[1].files.size(), 2U) << "a clip of the future is there";
    EXPECT_EQ(ahead[1].clip.modified, 30) << "all are of the future: the clock was set back";
    const auto one_ahead =
        archive::group_by_day(clips, footage::RecorderNames(), {now - nanoseconds(5), nanoseconds(2)}).days;
    EXPECT_EQ(one_ahead[1].files.size(), 2U);
    EXPECT_EQ(one_ahead[1].clip.modified, 20) << "a time of the future is not that of the newest";
}

TEST(CameraDays, OfNightsHaveTheDateOfTheirEvening) {
    using std::chrono::hours;
    using std::chrono::minutes;
    struct Row {
        const char* zone;
        const char* utc;
        minutes begins;
        const char* date;
    };
    // In Berlin the clock went back from 3:00 to 2:00 on 2026-10-25, and forward from 2:00 to 3:00 on 2026-03-29.
    const Row rows[] = {
        {"Europe/Berlin", "2026-11-21 10:59:59", hours(12), "2026-11-20"},
        {"Europe/Berlin", "2026-11-21 11:00:00", hours(12), "2026-11-21"},
        {"Europe/Berlin", "2026-11-22 10:59:59", hours(12), "2026-11-21"},
        {"America/New_York", "2026-11-21 16:59:59", hours(12), "2026-11-20"},
        {"Europe/Berlin", "2026-10-24 10:00:00", hours(12), "2026-10-24"},  // a night of 25 hours
        {"Europe/Berlin", "2026-10-25 10:59:59", hours(12), "2026-10-24"},
        {"Europe/Berlin", "2026-10-25 11:00:00", hours(12), "2026-10-25"},
        {"Europe/Berlin", "2026-03-28 11:00:00", hours(12), "2026-03-28"},  // a night of 23 hours
        {"Europe/Berlin", "2026-03-29 09:59:59", hours(12), "2026-03-28"},
        {"Europe/Berlin", "2026-03-29 10:00:00", hours(12), "2026-03-29"},
        {"Europe/Berlin", "2026-10-25 00:29:59", minutes(150), "2026-10-24"},  // 2:30 comes twice
        {"Europe/Berlin", "2026-10-25 00:30:00", minutes(150), "2026-10-25"},
        {"Europe/Berlin", "2026-10-25 01:10:00", minutes(150), "2026-10-25"},
        {"Europe/Berlin", "2026-03-29 00:59:59", minutes(150), "2026-03-28"},  // 2:30 doesn't come
        {"Europe/Berlin", "2026-03-29 01:00:00", minutes(150), "2026-03-29"},
        {"UTC", "1970-01-01 00:00:00", hours(12), "1969-12-31"},
    };
    for (const Row& row : rows) {
        const test::InZone zone(row.zone);
        std::tm parts{};
        ::strptime(row.utc, "%Y-%m-%d %H:%M:%S", &parts);
        EXPECT_EQ(archive::date_of(::timegm(&parts), {row.begins}), row.date) << row.utc << ' ' << row.zone;
    }
}

}  // namespace
}  // namespace vvr
