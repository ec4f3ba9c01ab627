#include "core/archive/sidecar.h"

#include <filesystem>
#include <string>
#include <vector>

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "core/archive/clips.h"
#include "core/archive/output_files.h"
#include "core/archive/pieces.h"
#include "core/archive/prune.h"
#include "core/base/error.h"
#include "core/footage/piece_names.h"
#include "tests/unit/archive/archive.h"

namespace vvr {
namespace {

namespace fs = std::filesystem;
using test::Archive;
using test::replaced;

TEST_F(Archive, ReadsWhatItWroteOfAClip) {
    archive::Sidecar sidecar = done("cam/\xFF.avi", {archive::OutputKind::picture, archive::OutputKind::report});
    sidecar.events = 3;
    sidecar.recorded = "2026-11-21 08:00:07";
    sidecar.seconds = 12.5;
    sidecar.stills = {3, 17, 125};
    archive::write_sidecar(out(), sidecar);
    const auto read = archive::read_sidecar(out(), sidecar.clip.path);
    ASSERT_TRUE(read);
    EXPECT_EQ(archive::format_sidecar(*read), archive::format_sidecar(sidecar));
    EXPECT_EQ(read->clip.path, "cam/\xFF.avi");
    EXPECT_EQ(read->files, sidecar.files);
    EXPECT_EQ(read->stills, sidecar.stills);

    sidecar.state = archive::Sidecar::State::failed;
    sidecar.reason = "no \"video\" \xFF";
    sidecar.code = ErrorCode::no_video_stream;
    sidecar.tries = 2;
    archive::write_sidecar(out(), sidecar);
    const auto failed = archive::read_sidecar(out(), sidecar.clip.path);
    EXPECT_EQ(failed->code, ErrorCode::no_video_stream);
    EXPECT_EQ(failed->tries, 2);
    EXPECT_EQ(failed->state, archive::Sidecar::State::failed);
}

TEST_F(Archive, RemovesOnlyThePiecesOfAClip) {
    archive::Sidecar sidecar = done("cam/a.avi");
    sidecar.pieces = {"event-1.mp4", "evidence.json", "SHA256SUMS"};
    const fs::path folder = archive::pieces_folder(out(), "cam/a.avi");
    for (const std::string& name : sidecar.pieces) write(folder / name);
    write(folder / "event-2.mp4");
    write(folder / "mine.txt");
    archive::write_sidecar(out(), sidecar);
    const auto read = archive::read_sidecar(out(), "cam/a.avi");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->pieces, sidecar.pieces);
    EXPECT_EQ(archive::format_sidecar(*read), archive::format_sidecar(sidecar));
    EXPECT_TRUE(archive::has_pieces(folder, sidecar.pieces));
    const std::vector<std::string> there{"SHA256SUMS", "event-1.mp4", "event-2.mp4", "evidence.json"};
    EXPECT_EQ(archive::list_pieces(folder), there);
    EXPECT_EQ(archive::remove_outputs(out(), *read).size(), 5U);
    EXPECT_FALSE(archive::has_pieces(folder, sidecar.pieces));
    EXPECT_EQ(archive::list_pieces(folder), std::vector<std::string>{"event-2.mp4"});
    EXPECT_TRUE(fs::exists(folder / "mine.txt"));

    // Names that vvr gives no piece are foreign, wherever they lead.
    const std::string forged = replaced(archive::format_sidecar(sidecar), "event-1.mp4", "../a.avi.png");
    EXPECT_EQ(archive::parse_sidecar(forged)->pieces, (std::vector<std::string>{"evidence.json", "SHA256SUMS"}));
}

TEST_F(Archive, MovesPiecesIntoNoOtherFolder) {
    write(in() / "event-1.mp4");
    const std::vector<std::string> names{"event-1.mp4"};
    fs::create_directories(out() / "elsewhere");
    const fs::path folder = archive::pieces_folder(out(), "a.avi");
    fs::create_directory_symlink("elsewhere", folder);
    EXPECT_THROW(archive::move_pieces(in(), folder, names), Error);
    EXPECT_TRUE(fs::is_empty(out() / "elsewhere"));
    write(out() / "elsewhere/event-1.mp4");
    EXPECT_TRUE(archive::list_pieces(folder).empty());
    EXPECT_TRUE(archive::remove_pieces(folder, names).empty());
    EXPECT_TRUE(fs::exists(out() / "elsewhere/event-1.mp4"));
    fs::remove(folder);
    fs::create_directories(folder / "event-1.mp4");
    EXPECT_THROW(archive::move_pieces(in(), folder, names), Error);
    fs::remove(folder / "event-1.mp4");
    archive::move_pieces(in(), folder, names);
    EXPECT_TRUE(fs::exists(folder / "event-1.mp4"));
    archive::remove_pieces(folder, names);
    EXPECT_FALSE(fs::exists(folder));
}

TEST(Pieces, HaveNamesOfTheirOwn) {
    for (const char* name : {"event-1.mp4", "event-120.webm", "event-7.avi", "evidence.json", "SHA256SUMS"})
        EXPECT_TRUE(footage::is_piece_name(name)) << name;
    for (const char* name :
         {"", "event-.mp4", "event-0.mp4", "event-01.mp4", "event-1", "event-1.mp4.part", "event-1.exe", "event--1.mp4",
          "../event-1.mp4", "event-1/2.mp4", "event-99999999999999999999.mp4", "Event-1.mp4", "evidence.json2"})
        EXPECT_FALSE(footage::is_piece_name(name)) << name;
    EXPECT_EQ(footage::piece_name(12, ".mkv"), "event-12.mkv");
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
        const std::string from(what);
        const std::string forged = replaced(text, from, from.substr(0, from.find(' ') + 1) + number);
        EXPECT_FALSE(archive::parse_sidecar(forged)) << what << " " << number;
    }
}

TEST_F(Archive, KnowsTheClipsOfADayAndWhatAFailureShows) {
    archive::Sidecar sidecar = done("gate/2026-11-21");
    sidecar.day = archive::Sidecar::Day{
        "gate", "2026-11-21", 3, {"gate/2026-11-21/08/00.avi", "gate/2026-11-21/08/\xFF%.avi", "x.avi"}};
    sidecar.day->rule = {std::chrono::minutes(12 * 60 + 30)};
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
    EXPECT_EQ(read->day->rule, sidecar.day->rule);
    const std::string text = archive::format_sidecar(sidecar);
    EXPECT_FALSE(archive::parse_sidecar(replaced(text, "2026-11-21\",\n", "../../../x\",\n")));
    EXPECT_FALSE(archive::parse_sidecar(replaced(text, "\"x.avi\"", "\"../x\"")));
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
    EXPECT_EQ(problem, "it is a link, not a file");
    EXPECT_THROW(archive::check_own_place(file), Error);
    fs::remove(file);
    ASSERT_EQ(::mkfifo(file.c_str(), 0666), 0);
    EXPECT_FALSE(read());
    EXPECT_EQ(problem, "it is a pipe, not a file");
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

TEST_F(Archive, TakesNothingElseForASidecar) {
    const std::string text = archive::format_sidecar(done("a.avi"));
    write(out() / "b.avi.json", text);  // a copy speaks of another clip
    for (const char* other : {"", "{", "[]", "{\"vvr-archive\": 1}", "{\"clip\": 3}", "null"}) {
        EXPECT_FALSE(archive::read_sidecar(out(), "b.avi"));
        write(out() / "b.avi.json", other);
    }
    write(out() / "a.avi.json", replaced(text, "\"vvr-archive\": 1", "\"vvr-archive\": 2"));
    EXPECT_FALSE(archive::read_sidecar(out(), "a.avi"));
    write(out() / "a.avi.json", replaced(text, "\"a.avi.png\"", "\"../../x\""));
    EXPECT_TRUE(archive::read_sidecar(out(), "a.avi")->files.empty()) << "names a file that is not its own";
}

}  // namespace
}  // namespace vvr
