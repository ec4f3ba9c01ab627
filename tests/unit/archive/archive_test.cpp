#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <tuple>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/archive/claim.h"
#include "core/archive/clips.h"
#include "core/archive/index.h"
#include "core/archive/output_files.h"
#include "core/archive/prune.h"
#include "core/archive/sidecar.h"
#include "core/archive/verdict.h"
#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/image/atomic_file.h"

namespace vvr {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class Archive : public ::testing::Test {
  protected:
    Archive() : top_(fs::temp_directory_path() / ("vvr-archive-" + std::to_string(::getpid()))) {
        fs::remove_all(top_);
        fs::create_directories(in());
        fs::create_directories(out());
    }
    ~Archive() override { fs::remove_all(top_); }

    fs::path in() const { return top_ / "in"; }
    fs::path out() const { return top_ / "out"; }

    static void write(const fs::path& path, const std::string& text = "x") {
        fs::create_directories(path.parent_path());
        std::ofstream(path) << text;
    }

    /// The file of a claim to `name`, as one who was killed leaves it, with any text in it.
    fs::path leave_claim(const std::string& name, const std::string& text) const {
        char file[64];
        std::snprintf(file, sizeof file, ".vvr-%016lx.lock", static_cast<unsigned long>(fnv1a(name)));
        write(out() / file, text);
        return out() / file;
    }

    std::vector<std::string> found(const archive::ClipNames& names = archive::ClipNames()) const {
        std::vector<std::string> paths;
        for (const archive::Clip& clip : archive::scan_archive(in(), out(), names).clips) paths.push_back(clip.path);
        return paths;
    }

    archive::Sidecar done(const std::string& clip,
                          const std::vector<archive::OutputKind>& files = {archive::OutputKind::picture}) const {
        archive::Sidecar sidecar;
        sidecar.clip = {clip, 3, 1'000'000'000};
        sidecar.settings = "s";
        sidecar.version = "1.2.3";
        sidecar.files = files;
        for (const archive::OutputKind kind : files) write(archive::output_path(out(), clip, kind));
        fs::create_directories(archive::sidecar_path(out(), clip).parent_path());
        archive::write_sidecar(out(), sidecar);
        return sidecar;
    }

  private:
    fs::path top_;
};

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

TEST_F(Archive, RefusesNamesWhoseFilesWouldClash) {
    for (const char* name : {"index", "a", "a.report", "b.avi", "b.mp4", "c", "c.png/d"}) write(in() / name);
    const archive::Scan scan = archive::scan_archive(in(), out(), archive::ClipNames({"*"}));
    std::set<std::string> refused;
    for (const archive::ScanProblem& problem : scan.problems) refused.insert(problem.path);
    EXPECT_EQ(refused, (std::set<std::string>{"index", "a.report", "c"}));
    EXPECT_EQ(scan.clips.size(), 4);
}

TEST_F(Archive, RefusesNamesThatAreTooLong) {
    const std::string possible = std::string(239, 'n') + ".avi", long_one = "n" + possible;
    for (const std::string& name : {possible, long_one, std::string(251, 'm') + ".avi"}) write(in() / "cam" / name);
    const archive::Scan scan = archive::scan_archive(in(), out(), archive::ClipNames());
    EXPECT_EQ(found(), (std::vector<std::string>{"cam/" + possible}));
    ASSERT_EQ(scan.problems.size(), 2);
    EXPECT_EQ(scan.problems[1].path, "cam/" + long_one);
    EXPECT_EQ(scan.problems[1].reason, "its '" + long_one +
                                           ".report.json' would be too long a name (256 bytes, 255 are "
                                           "possible); rename the clip");
}

TEST_F(Archive, ReadsWhatItWroteOfAClip) {
    archive::Sidecar sidecar = done("cam/\xFF.avi", {archive::OutputKind::picture, archive::OutputKind::report});
    sidecar.events = 3;
    sidecar.recorded = "2026-11-21 08:00:07";
    sidecar.seconds = 12.5;
    archive::write_sidecar(out(), sidecar);
    const auto read = archive::read_sidecar(out(), sidecar.clip.path);
    ASSERT_TRUE(read);
    EXPECT_EQ(archive::format_sidecar(*read), archive::format_sidecar(sidecar));
    EXPECT_EQ(read->clip.path, "cam/\xFF.avi");
    EXPECT_EQ(read->files, sidecar.files);

    sidecar.state = archive::Sidecar::State::failed;
    sidecar.reason = "no \"video\" \xFF";
    sidecar.code = ErrorCode::no_video_stream;
    sidecar.tries = 2;
    archive::write_sidecar(out(), sidecar);
    EXPECT_EQ(archive::read_sidecar(out(), sidecar.clip.path)->code, ErrorCode::no_video_stream);
    EXPECT_EQ(archive::read_sidecar(out(), sidecar.clip.path)->tries, 2);
    EXPECT_EQ(archive::read_sidecar(out(), sidecar.clip.path)->state, archive::Sidecar::State::failed);
}

TEST_F(Archive, ReadsNoNumberThatCannotBe) {
    const std::string text = archive::format_sidecar(done("a.avi"));
    ASSERT_TRUE(archive::parse_sidecar(text));
    for (const auto& [what, number] : {std::pair{"\"seconds\": 0.0", "1e15"},
                                       {"\"seconds\": 0.0", "-1"},
                                       {"\"modified_ns\": 1000000000", "9000000000000000000"},
                                       {"\"modified_ns\": 1000000000", "-1"},
                                       {"\"modified_ns\": 1000000000", "1e18"},
                                       {"\"tries\": 1", "18446744073709551615"},
                                       {"\"frames\": 0", "-7"},
                                       {"\"bytes\": 3", "1e300"},
                                       {"\"status\": 0", "99999"}}) {
        std::string forged = text;
        const std::string from(what);
        ASSERT_NE(forged.find(from), std::string::npos) << what;
        forged.replace(forged.find(from), from.size(), from.substr(0, from.find(' ') + 1) + number);
        EXPECT_FALSE(archive::parse_sidecar(forged)) << what << " " << number;
    }
}

TEST_F(Archive, KnowsTheClipsOfADayAndWhatAFailureShows) {
    archive::Sidecar sidecar = done("gate/2026-11-21");
    sidecar.day = archive::Sidecar::Day{
        "gate", "2026-11-21", 3, {"gate/2026-11-21/08/00.avi", "gate/2026-11-21/08/\xFF%.avi", "x.avi"}};
    sidecar.state = archive::Sidecar::State::failed;
    sidecar.shows.emplace();
    sidecar.shows->clip = {"gate/2026-11-21", 2, 900'000'000};
    sidecar.frames = 7;
    const auto read = archive::parse_sidecar(archive::format_sidecar(sidecar));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->day->files, sidecar.day->files);
    ASSERT_TRUE(read->shows);
    EXPECT_EQ(read->shows->clip.modified, 900'000'000);
    EXPECT_EQ(read->frames, 7);
    EXPECT_EQ(archive::format_sidecar(*read), archive::format_sidecar(sidecar));
    std::string out_of_folder = archive::format_sidecar(sidecar);
    out_of_folder.replace(out_of_folder.find("\"x.avi\""), 7, "\"../x\"");
    EXPECT_FALSE(archive::parse_sidecar(out_of_folder));
}

TEST_F(Archive, ReadsOnlyFilesOfItsOwn) {
    write(in() / "elsewhere.json", archive::format_sidecar(done("a.avi")));
    const fs::path file = archive::sidecar_path(out(), "a.avi");
    std::string problem;
    const auto read = [&] { return archive::read_sidecar_file(out(), "a.avi.json", &problem).has_value(); };
    EXPECT_TRUE(read());
    EXPECT_EQ(problem, "");
    fs::remove(file);
    EXPECT_FALSE(read());
    EXPECT_EQ(problem, "") << "nothing is there";
    fs::create_symlink(in() / "elsewhere.json", file);
    EXPECT_FALSE(read());
    EXPECT_EQ(problem, "it is a link, and no file");
    EXPECT_THROW(archive::check_own_place(file), Error);
    fs::remove(file);
    ASSERT_EQ(::mkfifo(file.c_str(), 0666), 0);
    EXPECT_FALSE(read());
    EXPECT_EQ(problem, "it is a pipe, and no file");
    fs::remove(file);
    write(file, "{\n  \"vvr-archive\": 1,");
    fs::resize_file(file, std::uintmax_t{1} << 36);
    EXPECT_FALSE(read());
    EXPECT_NE(problem.find("at most"), std::string::npos) << problem;
    const archive::Outputs outputs = archive::list_outputs(out(), in());
    ASSERT_EQ(outputs.problems.size(), 1U);
    EXPECT_EQ(outputs.problems[0].path, "a.avi.json");
    fs::create_directories(out() / "gate");
    EXPECT_NO_THROW(archive::check_own_folder(out(), out() / "gate/new"));
    fs::create_directory_symlink("gate", out() / "link");
    EXPECT_THROW(archive::check_own_folder(out(), out() / "link"), Error);
    EXPECT_THROW(archive::check_own_folder(out(), out() / "link/below"), Error);
}

TEST_F(Archive, WaitsNoLongerForALockThanItMay) {
    const auto held = archive::LockFile::try_take(out(), "index.html");
    EXPECT_THROW(archive::LockFile::wait_for(out(), "index.html", 50ms), Error);
    EXPECT_NO_THROW(archive::LockFile::wait_for(out(), "other.html", 50ms));
}

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

TEST_F(Archive, TakesNothingElseForASidecar) {
    const std::string text = archive::format_sidecar(done("a.avi"));
    write(out() / "b.avi.json", text);  // a copy speaks of another clip
    for (const char* other : {"", "{", "[]", "{\"vvr-archive\": 1}", "{\"clip\": 3}", "null"}) {
        EXPECT_FALSE(archive::read_sidecar(out(), "b.avi"));
        write(out() / "b.avi.json", other);
    }
    std::string newer = text;
    newer.replace(newer.find("\"vvr-archive\": 1"), 16, "\"vvr-archive\": 2");
    write(out() / "a.avi.json", newer);
    EXPECT_FALSE(archive::read_sidecar(out(), "a.avi"));
    std::string strange = text;
    strange.replace(strange.find("\"a.avi.png\""), 11, "\"../../x\"");
    write(out() / "a.avi.json", strange);
    EXPECT_TRUE(archive::read_sidecar(out(), "a.avi")->files.empty()) << "names a file that is not its own";
}

TEST_F(Archive, DecidesWhatIsToBeDone) {
    const auto now = std::chrono::system_clock::now();
    const archive::ArchiveRules rules{"s", "1.2.3", {archive::OutputKind::picture}, 3, 60s};
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
    fs::remove(archive::output_path(out(), "a.avi", archive::OutputKind::picture));
    EXPECT_EQ(need(clip, sidecar), archive::Need::missing);

    sidecar.state = archive::Sidecar::State::failed;
    sidecar.tries = 2;
    EXPECT_EQ(need(clip, sidecar), archive::Need::retry);
    sidecar.tries = 3;
    EXPECT_EQ(need(clip, sidecar), archive::Need::given_up);
    sidecar.version = "1.0.0";
    EXPECT_EQ(need(clip, sidecar), archive::Need::retry) << "another version may know better";

    const auto modified = [&](std::chrono::nanoseconds ago) {
        return archive::Clip{"a.avi", 3, (now.time_since_epoch() - ago).count()};
    };
    EXPECT_EQ(need(modified(1s), {}), archive::Need::still_written);
    EXPECT_EQ(need(modified(59s), sidecar), archive::Need::still_written);
    EXPECT_EQ(need(modified(61s), {}), archive::Need::added);
    EXPECT_EQ(need(modified(-30s), {}), archive::Need::still_written);
    EXPECT_EQ(need(modified(-24h), {}), archive::Need::added) << "a clock that runs ahead";
}

TEST_F(Archive, IsClaimedByOneAtATime) {
    auto first = archive::LockFile::try_take(out(), "a.avi");
    ASSERT_TRUE(first);
    EXPECT_FALSE(first->is_stale());
    EXPECT_FALSE(archive::LockFile::try_take(out(), "a.avi"));
    EXPECT_TRUE(archive::LockFile::try_take(out(), "b.avi"));
    const fs::path file = fs::directory_iterator(out())->path();
    EXPECT_TRUE(archive::LockFile::is_lock_file(file));
    EXPECT_FALSE(archive::LockFile::take_over(file));
    first.reset();
    EXPECT_TRUE(fs::is_empty(out())) << "a claim leaves no file";
    EXPECT_TRUE(archive::LockFile::try_take(out(), std::string(255, 'a')));
    EXPECT_THROW(archive::LockFile::try_take(out() / "none", "a"), Error);
}

TEST_F(Archive, TidiesAfterThoseWhoWereKilled) {
    const pid_t child = ::fork();
    if (child == 0) {
        const auto claim = archive::LockFile::try_take(out(), "a.avi");
        ::_exit(claim ? 0 : 1);  // without a destructor, as SIGKILL would
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_EQ(status, 0);
    write(out() / "a.avi.png");
    write(out() / "other.png");
    {
        const auto claim = archive::LockFile::try_take(out(), "a.avi");
        ASSERT_TRUE(claim);
        EXPECT_TRUE(claim->is_stale());
        archive::tidy(out(), archive::list_outputs(out(), in()));
        EXPECT_TRUE(fs::exists(out() / "a.avi.png")) << "somebody is at it";
    }
    const pid_t other = ::fork();
    if (other == 0) {
        const auto claim = archive::LockFile::try_take(out(), "a.avi");
        ::_exit(claim ? 0 : 1);
    }
    ASSERT_EQ(::waitpid(other, &status, 0), other);
    archive::tidy(out(), archive::list_outputs(out(), in()));
    EXPECT_FALSE(fs::exists(out() / "a.avi.png")) << "half of a clip's files that nobody will finish";
    EXPECT_TRUE(fs::exists(out() / "other.png"));
    EXPECT_EQ(std::distance(fs::directory_iterator(out()), {}), 1);
}

TEST_F(Archive, TakesOverNoClaimThatIsNone) {
    write(out() / "victim/photo.png");
    write(out() / "photo.png");
    std::vector<fs::path> files;
    for (const std::string& name : {std::string("victim/photo"), std::string("../out/victim/photo"), std::string("."),
                                    (out() / "victim/photo").string(), std::string(".."), std::string(),
                                    std::string("photo\0", 6), std::string(longest_name + 1, 'n')}) {
        files.push_back(leave_claim(name, name));
    }
    files.push_back(leave_claim("another name", "photo"));
    write(out() / "elsewhere", "photo");
    files.push_back(leave_claim("photo", ""));
    fs::remove(files.back());
    fs::create_symlink("elsewhere", files.back());
    files.push_back(leave_claim("pipe", ""));
    fs::remove(files.back());
    ASSERT_EQ(::mkfifo(files.back().c_str(), 0666), 0);
    for (const fs::path& file : files) {
        EXPECT_TRUE(archive::LockFile::is_lock_file(file));
        EXPECT_FALSE(archive::LockFile::take_over(file)) << file;
        EXPECT_TRUE(fs::exists(file)) << file;
    }
    archive::tidy(out(), archive::list_outputs(out(), in()));
    EXPECT_TRUE(fs::exists(out() / "victim/photo.png"));
    EXPECT_TRUE(fs::exists(out() / "photo.png"));
    EXPECT_TRUE(archive::LockFile::take_over(leave_claim("good", "good")));
}

TEST_F(Archive, ClaimsThroughNoLink) {
    const fs::path file = leave_claim("a.avi", "");
    for (const char* target : {"nowhere", "empty"}) {
        write(out() / "empty", "");
        fs::remove(file);
        fs::create_symlink(target, file);
        EXPECT_THROW(archive::LockFile::try_take(out(), "a.avi"), Error);
        EXPECT_FALSE(fs::exists(out() / "nowhere"));
        EXPECT_TRUE(fs::is_empty(out() / "empty"));
        EXPECT_TRUE(fs::is_symlink(file));
    }
    fs::remove(file);
    ASSERT_EQ(::mkfifo(file.c_str(), 0666), 0);
    EXPECT_THROW(archive::LockFile::try_take(out(), "a.avi"), Error);
    EXPECT_TRUE(fs::exists(file));
}

TEST_F(Archive, TidiesOnlyWhatIsTheClips) {
    done("x.report");
    leave_claim("x", "x");
    leave_claim("index", "index");
    write(out() / "index.html");
    write(out() / "x.png");
    fs::create_symlink("index.html", out() / "x.html");
    fs::create_directory(out() / "x.jpg");
    archive::tidy(out(), archive::list_outputs(out(), in()));
    EXPECT_FALSE(fs::exists(out() / "x.png"));
    EXPECT_TRUE(fs::is_symlink(out() / "x.html"));
    EXPECT_TRUE(fs::exists(out() / "x.jpg"));
    EXPECT_TRUE(fs::exists(out() / "index.html"));
    EXPECT_TRUE(archive::read_sidecar(out(), "x.report")) << "where the report of x would be";
    EXPECT_TRUE(archive::list_outputs(out(), in()).claims.empty());
}

TEST_F(Archive, RemovesLeftoversOfItsOwnNamesOnly) {
    const auto hidden = [&](const std::string& name) {
        char text[64];
        std::snprintf(text, sizeof text, ".vvr-%016lx-1-0.part", static_cast<unsigned long>(fnv1a(name)));
        write(out() / text);
        return out() / text;
    };
    const fs::path ours = hidden("a.avi.png"), theirs = hidden("b.avi.png");
    const std::vector<std::string> names = archive::written_names("a.avi");
    image::remove_leftovers(out(), names);
    EXPECT_FALSE(fs::exists(ours));
    EXPECT_TRUE(fs::exists(theirs));
}

TEST_F(Archive, ForgetsOnlyClipsThatHaveCertainlyGone) {
    const video::RecorderNames recorders;
    write(in() / "there.avi");
    write(in() / "gate/2026-11-20/x.avi");
    fs::create_directories(in() / "unmounted");
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
             {"linked/a.avi", archive::SourceState::away, "linked"},
             {"no camera/b.avi", archive::SourceState::away, "no camera"},
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
    EXPECT_EQ(day("2026-11-19", {}), archive::SourceState::unknown) << "an older sidecar";
    write(in() / "gate/2026-11-19 08-00-00.avi");
    EXPECT_EQ(day("2026-11-19", {"gate/2026-11-19/x.avi"}), archive::SourceState::there)
        << "another clip of the day is there";
    write(in() / "gate/2026-11-20" / (std::string(250, 'n') + ".avi"));
    EXPECT_NO_THROW(
        archive::check_can_prune(in(), archive::find_present(in(), out(), archive::ClipNames(), recorders)));
    fs::create_symlink("nowhere", in() / "broken.avi");
    EXPECT_THROW(archive::check_can_prune(in(), archive::find_present(in(), out(), archive::ClipNames(), recorders)),
                 Error);
    fs::remove_all(in());
    fs::create_directories(in());
    EXPECT_THROW(archive::check_can_prune(in(), archive::find_present(in(), out(), archive::ClipNames(), recorders)),
                 Error);

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

TEST(CameraDays, AreOfTheDayOnTheLocalWall) {
    ::setenv("TZ", "Europe/Berlin", 1);
    ::tzset();
    const std::vector<archive::Clip> clips{{"2026-11-21/22/gate/59.50.mp4", 5, 10},
                                           {"2026-11-21/23/gate/00.00.mp4", 7, 20},
                                           {"2026-11-21/23/gate/00.10.mp4", 9, 30},
                                           {"hall/x.mp4", 1, 20}};
    using std::chrono::nanoseconds;
    const std::chrono::system_clock::time_point now{nanoseconds(30)};
    const archive::CameraDays grouped = archive::group_by_day(clips, video::RecorderNames(), {now, nanoseconds(10)});
    const auto& days = grouped.days;
    ASSERT_EQ(days.size(), 3U);
    EXPECT_EQ(days[0].clip.path, "gate/2026-11-21");
    EXPECT_EQ(days[1].clip.path, "gate/2026-11-22") << "Frigate's hour 23 is past midnight in Berlin";
    EXPECT_EQ(days[1].files.size(), 1U) << "the newest is still being written";
    EXPECT_EQ(grouped.waiting, 1U);
    EXPECT_EQ(days[2].clip.path, "hall/1970-01-01") << "by when it was written";
    EXPECT_TRUE(grouped.problems.empty());

    const std::chrono::system_clock::time_point before{nanoseconds(5)};
    const auto ahead = archive::group_by_day(clips, video::RecorderNames(), {before, nanoseconds(2)}).days;
    EXPECT_EQ(ahead[1].files.size(), 2U) << "a clip of the future is there";
    EXPECT_EQ(ahead[1].clip.modified, 30) << "all are of the future: the clock was set back";
    const auto one_ahead =
        archive::group_by_day(clips, video::RecorderNames(), {now - nanoseconds(5), nanoseconds(2)}).days;
    EXPECT_EQ(one_ahead[1].files.size(), 2U);
    EXPECT_EQ(one_ahead[1].clip.modified, 20) << "a time of the future is not that of the newest";
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
    for (const char* absurd :
         {"2026-11-21 4294967295:00:00", "2026-11-21 25:00:00", "9999-11-21 08:00:07", "-026-11-21 08:00:07"}) {
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
