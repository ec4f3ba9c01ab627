#include <chrono>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "core/archive/clips.h"
#include "core/archive/need.h"
#include "core/archive/output_files.h"
#include "core/archive/prune.h"
#include "core/archive/sidecar.h"
#include "core/base/error.h"
#include "core/footage/recorder_names.h"
#include "tests/unit/archive/archive.h"

namespace vvr {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using test::Archive;

TEST_F(Archive, DecidesWhatIsToBeDone) {
    const auto now = std::chrono::system_clock::now();
    const archive::ArchiveRules rules{"s", "1.2.3", {archive::OutputKind::picture}, 3, 60s};
    archive::ArchiveRules with_limits = rules;
    with_limits.limits = {7200, 2000};
    archive::Sidecar sidecar = done("a.avi");
    const archive::Clip clip = sidecar.clip;
    const auto need = [&](const archive::Clip& there, const std::optional<archive::Sidecar>& known) {
        return archive::need_of(there, known, out(), rules, now);
    };
    EXPECT_EQ(need(clip, sidecar), archive::Need::nothing);
    EXPECT_EQ(need(clip, {}), archive::Need::added);
    EXPECT_EQ(need({"a.avi", 4, clip.modified}, sidecar), archive::Need::changed);
    EXPECT_EQ(need({"a.avi", 3, clip.modified + 1}, sidecar), archive::Need::changed);
    archive::Sidecar other = sidecar;
    other.settings = "t";
    EXPECT_EQ(need(clip, other), archive::Need::settings);
    other = sidecar;
    other.version = "1.0.0";
    EXPECT_EQ(need(clip, other), archive::Need::nothing) << "a picture that is there stays, whatever drew it";
    other = sidecar;
    other.code = ErrorCode::partial;
    EXPECT_EQ(need(clip, other), archive::Need::nothing) << "another try would keep no more events";
    other.code = ErrorCode::file_not_found;
    EXPECT_EQ(need(clip, other), archive::Need::retry);
    other.tries = 3;
    EXPECT_EQ(need(clip, other), archive::Need::nothing);
    fs::remove(archive::output_path(out(), "a.avi", archive::OutputKind::picture));
    EXPECT_EQ(need(clip, sidecar), archive::Need::missing);

    sidecar.state = archive::Sidecar::State::failed;
    sidecar.tries = 2;
    EXPECT_EQ(need(clip, sidecar), archive::Need::retry);
    sidecar.tries = 3;
    EXPECT_EQ(need(clip, sidecar), archive::Need::given_up);
    sidecar.version = "1.0.0";
    EXPECT_EQ(need(clip, sidecar), archive::Need::retry) << "another version may know better";

    sidecar.version = rules.version;
    const auto after = [&](ErrorCode code, const archive::TryLimits& limits) {
        archive::Sidecar failed = sidecar;
        failed.code = code;
        failed.limits = limits;
        return archive::need_of(clip, failed, out(), with_limits, now);
    };
    EXPECT_EQ(after(ErrorCode::worker_timeout, {7199, 3000}), archive::Need::retry);
    EXPECT_EQ(after(ErrorCode::worker_timeout, {7200, 1000}), archive::Need::given_up);
    EXPECT_EQ(after(ErrorCode::worker_killed, {7200, 1999}), archive::Need::retry);
    EXPECT_EQ(after(ErrorCode::out_of_memory, {3600, 2000}), archive::Need::given_up);
    EXPECT_EQ(after(ErrorCode::not_video, {1, 1}), archive::Need::given_up) << "no limit was in its way";
    with_limits.limits.seconds = 0;
    EXPECT_EQ(after(ErrorCode::worker_timeout, {7200, 1000}), archive::Need::retry) << "without a limit";

    const auto modified = [&](std::chrono::nanoseconds ago) {
        return archive::Clip{"a.avi", 3, (now.time_since_epoch() - ago).count()};
    };
    EXPECT_EQ(need(modified(1s), {}), archive::Need::still_written);
    EXPECT_EQ(need(modified(59s), sidecar), archive::Need::still_written);
    EXPECT_EQ(need(modified(61s), {}), archive::Need::added);
    EXPECT_EQ(need(modified(-30s), {}), archive::Need::still_written);
    EXPECT_EQ(need(modified(-24h), {}), archive::Need::added) << "a clock that runs ahead";
}

TEST_F(Archive, TriesAgainADayAfterALackOfMemory) {
    const archive::ArchiveRules rules{"s", "1.2.3", {archive::OutputKind::picture}};
    archive::Sidecar sidecar = done("a.avi");
    sidecar.state = archive::Sidecar::State::failed;
    sidecar.tries = 3;
    archive::write_sidecar(out(), sidecar);
    const auto need = [&](ErrorCode code, int status) {
        sidecar.code = code;
        sidecar.status = status;
        return archive::need_of(sidecar.clip, sidecar, out(), rules, std::chrono::system_clock::now());
    };
    EXPECT_EQ(need(ErrorCode::out_of_memory, 5), archive::Need::given_up);
    fs::last_write_time(archive::sidecar_path(out(), "a.avi"), fs::file_time_type::clock::now() - 25h);
    EXPECT_EQ(need(ErrorCode::out_of_memory, 5), archive::Need::retry);
    EXPECT_EQ(need(ErrorCode::worker_killed, 137), archive::Need::retry) << "the kernel's way out";
    EXPECT_EQ(need(ErrorCode::worker_killed, 139), archive::Need::given_up) << "the clip's own fault";
    EXPECT_EQ(need(ErrorCode::not_video, 3), archive::Need::given_up);
}

TEST_F(Archive, ForgetsOnlyClipsThatHaveCertainlyGone) {
    const footage::RecorderNames recorders;
    write(in() / "there.avi");
    write(in() / "gate/2026-11-20/x.avi");
    fs::create_directories(in() / "unmounted");
    write(in() / "hidden/.keep");
    write(in() / "notes/read me.txt");
    fs::create_directory_symlink("nowhere", in() / "linked");
    const auto fate = [&](const archive::Sidecar& sidecar, const archive::ClipNames& names = archive::ClipNames()) {
        return archive::source_state_of(in(), sidecar, archive::find_present(in(), out(), names, recorders), recorders);
    };
    for (const auto& [clip, expected, folder] : {
             std::tuple{"there.avi", archive::SourceState::there, ""},
             {"gone.avi", archive::SourceState::gone, ""},
             {"gate/2026-11-20/y.avi", archive::SourceState::gone, ""},
             {"gate/2026-11-19/x.avi", archive::SourceState::gone, ""},
             {"2026-11-19/08/x.avi", archive::SourceState::gone, ""},
             {"unmounted/a.avi", archive::SourceState::away, "unmounted"},
             {"unmounted/deep/a.avi", archive::SourceState::away, "unmounted"},
             {"hidden/a.avi", archive::SourceState::away, "hidden"},
             {"hidden/deep/a.avi", archive::SourceState::away, "hidden"},
             {"notes/a.avi", archive::SourceState::gone, ""},
             {"linked/a.avi", archive::SourceState::away, "linked"},
             {"no camera/b.avi", archive::SourceState::away, "no camera"},
             {"D01/a.avi", archive::SourceState::away, "D01"},
             {"10B/a.avi", archive::SourceState::away, "10B"},
             {"192.168.1.10/a.avi", archive::SourceState::away, "192.168.1.10"},
             {"07/a.avi", archive::SourceState::gone, ""},
             {"2026.11.21/a.avi", archive::SourceState::gone, ""},
             {"2026Y11M21D20H/a.avi", archive::SourceState::gone, ""},
         }) {
        const archive::SourceStatus verdict = fate(done(clip));
        EXPECT_EQ(verdict.fate, expected) << clip;
        EXPECT_EQ(verdict.folder, folder) << clip;
    }
    EXPECT_EQ(fate(done("there.avi"), archive::ClipNames({}, {"*"})).fate, archive::SourceState::there)
        << "left out by a run, and there";

    const auto day = [&](const std::string& date, const std::vector<std::string>& files) {
        archive::Sidecar sidecar = done("gate/" + date);
        sidecar.day = archive::Sidecar::Day{"gate", date, 1, files};
        return fate(sidecar).fate;
    };
    EXPECT_EQ(day("2026-11-19", {"gate/2026-11-19/x.avi", "gate/2026-11-19/y.avi"}), archive::SourceState::gone);
    EXPECT_EQ(day("2026-11-19", {"gate/2026-11-19/x.avi", "there.avi"}), archive::SourceState::there)
        << "one of its clips is left";
    EXPECT_EQ(day("2026-11-19", {"gate/2026-11-19/x.avi", "unmounted/y.avi"}), archive::SourceState::away);
    EXPECT_EQ(day("2026-11-19", {"gate/2026-11-20/x.avi", "there.avi"}), archive::SourceState::moved)
        << "all of its clips are there, in other days";
    EXPECT_EQ(day("2026-11-19", {}), archive::SourceState::unknown) << "an older sidecar";
    write(in() / "gate/2026-11-19 08-00-00.avi");
    EXPECT_EQ(day("2026-11-19", {"gate/2026-11-19/x.avi"}), archive::SourceState::there)
        << "another clip of the day is there";
    write(in() / "gate/2026-11-20" / (std::string(250, 'n') + ".avi"));
    const auto check_can_prune = [&] {
        archive::check_can_prune(in(), archive::find_present(in(), out(), archive::ClipNames(), recorders));
    };
    EXPECT_NO_THROW(check_can_prune());
    fs::create_symlink("nowhere", in() / "broken.avi");
    EXPECT_THROW(check_can_prune(), Error);
    fs::remove_all(in());
    fs::create_directories(in());
    EXPECT_THROW(check_can_prune(), Error);

    const archive::Sidecar gone = done("gone.avi");
    write(out() / "gone.avi.txt");
    archive::remove_outputs(out(), gone);
    EXPECT_FALSE(fs::exists(out() / "gone.avi.png"));
    EXPECT_FALSE(fs::exists(out() / "gone.avi.json"));
    EXPECT_TRUE(fs::exists(out() / "gone.avi.txt")) << "not ours";
}

TEST_F(Archive, DrawsADayAgainWhenEnoughHasCome) {
    using std::chrono::minutes;
    const auto ns = [](std::chrono::system_clock::time_point at) {
        return std::chrono::nanoseconds(at.time_since_epoch()).count();
    };
    const auto now = std::chrono::system_clock::now();
    archive::ArchiveRules rules;
    rules.redraw = minutes(15);
    archive::Sidecar before;
    before.clip = {"gate/2026-11-21", 100, ns(now - minutes(20))};
    before.settings = rules.settings;
    const auto need = [&](std::int64_t size, std::chrono::system_clock::time_point newest) {
        return archive::need_of_day({"gate/2026-11-21", size, ns(newest)}, before, out(), rules, now);
    };
    EXPECT_EQ(archive::need_of_day(before.clip, {}, out(), rules, now), archive::Need::added);
    EXPECT_EQ(need(100, now - minutes(20)), archive::Need::nothing);
    EXPECT_EQ(need(120, now - minutes(10)), archive::Need::later) << "ten minutes more, a while ago";
    EXPECT_EQ(need(150, now - minutes(2)), archive::Need::changed) << "eighteen minutes more";
    EXPECT_EQ(need(90, now - minutes(20)), archive::Need::nothing) << "the recorder removed some";
    before.clip.modified = ns(now - minutes(40));
    EXPECT_EQ(need(120, now - minutes(30)), archive::Need::changed) << "nothing has come since";
}

TEST(Gone, IsOnlyWhatIsCertainlyNotThere) {
    const test::TempFolder folder;
    fs::create_symlink("loop", folder / "loop");
    EXPECT_TRUE(archive::is_gone(folder / "none.avi"));
    EXPECT_TRUE(archive::is_gone(folder / "none/a.avi"));
    EXPECT_FALSE(archive::is_gone(folder / "loop")) << "the link is there";
    EXPECT_FALSE(archive::is_gone(folder / "loop/a.avi")) << "nobody knows";
}

}  // namespace
}  // namespace vvr
