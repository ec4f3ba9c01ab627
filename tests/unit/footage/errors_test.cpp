#include "tests/support/errors.h"

#include <csignal>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/footage/open_source.h"
#include "tests/unit/media/clips.h"

namespace vvr {
namespace {

using namespace test;

void expect_open_error(const std::string& name, ErrorCode code, std::initializer_list<std::string_view> facts,
                       const media::SourceOptions& options = {}) {
    SCOPED_TRACE(name);
    test::expect_error(
        code, [&] { footage::open_source(name, options); }, facts);
}

/// While it lives the process is a user whom permissions hold back, as root is by none.
class NotRoot {
  public:
    NotRoot() : user_(::geteuid()) {
        constexpr uid_t nobody = 65534;
        if (user_ == 0 && ::seteuid(nobody) != 0) throw std::runtime_error("seteuid failed");
    }
    ~NotRoot() {
        if (user_ == 0 && ::seteuid(user_) != 0) std::abort();
    }
    NotRoot(const NotRoot&) = delete;
    NotRoot& operator=(const NotRoot&) = delete;

  private:
    uid_t user_;
};

class VideoErrors : public testing::Test {
  protected:
    TempFolder folder;
};

TEST_F(VideoErrors, PicturesThatAreNone) {
    write_bytes(folder / "a.png", "text");
    write_bytes(folder / "b.png", "text");
    expect_open_error(folder.path(), ErrorCode::no_frame, {"any of the 2 pictures", "a.png"});
}

TEST_F(VideoErrors, PatternsWithoutMatch) {
    for (const std::string name : {"%05d.png", "*.png", "none/%05d.png"})
        expect_open_error(folder / name, ErrorCode::file_not_found, {name});
    for (const std::string name : {"%d_%d.png", "%s.png"})
        expect_open_error(folder / name, ErrorCode::name_pattern_invalid, {name});
}

// libav would draw these as pictures of a terminal.
TEST_F(VideoErrors, TextFile) {
    write_bytes(folder / "notes.txt", "hello\n");
    expect_open_error(folder / "notes.txt", ErrorCode::not_video, {"notes.txt"});
    write_bytes(folder / "art.ans", "\033[31mhello\n");
    expect_open_error(folder / "art.ans", ErrorCode::not_video, {"art.ans"});
}

TEST_F(VideoErrors, AudioWithACover) {
    ffmpeg("-f lavfi -i sine=d=1 " + quoted(folder / "sound.wav"));
    ffmpeg("-f lavfi -i color=s=32x32 -frames:v 1 -update 1 " + quoted(folder / "cover.png"));
    ffmpeg("-i " + quoted(folder / "sound.wav") + " -i " + quoted(folder / "cover.png") +
           " -map 0 -map 1 -c:v copy -disposition:v attached_pic " + quoted(folder / "cover.mp3"));
    expect_open_error(folder / "cover.mp3", ErrorCode::no_video_stream, {"cover picture (png)"});
}

TEST_F(VideoErrors, NoFrameDecodes) {
    const auto clip = walkers_clip(folder, "clip.mkv", "-c:v libx264 -g 1000");
    auto bytes = read_bytes(clip);
    for (std::size_t i = 1200; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 31);
    write_bytes(folder / "noise.mkv", bytes);
    expect_open_error(folder / "noise.mkv", ErrorCode::no_frame, {"noise.mkv"});
}

TEST_F(VideoErrors, CutBeforeItsIndex) {
    const auto clip = walkers_clip(folder, "clip.mp4", "-c:v libx264");
    expect_open_error(cut(folder, clip, 0.5), ErrorCode::not_video, {"cut.mp4", "moov atom not found"});
}

TEST_F(VideoErrors, UnreadableFile) {
    write_bytes(folder / "secret.avi", "x");
    ::chmod(folder.path().c_str(), 0755);  // it is the file that can't be read
    ::chmod((folder / "secret.avi").c_str(), 0);
    const NotRoot as_somebody;
    expect_open_error(folder / "secret.avi", ErrorCode::permission_denied, {"secret.avi"});
}

TEST_F(VideoErrors, Address) {
    expect_open_error("http://127.0.0.1:1/clip.mp4", ErrorCode::stream_unreachable,
                      {"http://127.0.0.1:1/clip.mp4", "Connection refused"});
    expect_open_error("nothing://clip", ErrorCode::stream_unreachable, {"nothing://clip", "Protocol not found"});
}

TEST_F(VideoErrors, RateThatCannotBe) {
    expect_open_error(counting_clip(folder, "clip.mkv", "-c:v ffv1"), ErrorCode::option_value_out_of_range,
                      {"rate: -1 "}, {.rate = -1});
}

TEST_F(VideoErrors, HugePicturesAreRefusedBeforeTheyAreAllocated) {
    // The size in a PNG's header, with its checksum.
    ffmpeg("-f lavfi -i color=s=16x16 -frames:v 1 -update 1 " + quoted(folder / "small.png"));
    auto png = read_bytes(folder / "small.png");
    for (const std::size_t at : {16u, 20u}) png.replace(at, 4, std::string("\0\0\xea\x60", 4));
    std::uint32_t sum = 0xffffffff;
    for (std::size_t i = 12; i < 29; ++i) {
        sum ^= static_cast<std::uint8_t>(png[i]);
        for (int bit = 0; bit < 8; ++bit) sum = sum & 1 ? (sum >> 1) ^ 0xedb88320u : sum >> 1;
    }
    for (std::size_t i = 0; i < 4; ++i) png[29 + i] = static_cast<char>(~sum >> (24 - 8 * i));
    write_bytes(folder / "huge.png", png);
    expect_open_error(folder / "huge.png", ErrorCode::no_frame, {"huge.png", "Invalid image size"});

    auto avi = read_bytes(walkers_clip(folder, "clip.avi", "-c:v mjpeg"));
    const std::string size("\xc0\0\0\0\x90\0\0\0", 8);
    for (auto at = avi.find(size); at < 1000; at = avi.find(size, at)) {
        avi.replace(at, 8, std::string("\x60\xea\0\0\x60\xea\0\0", 8));
    }
    write_bytes(folder / "huge.avi", avi);
    rusage before{};
    ::getrusage(RUSAGE_SELF, &before);
    try {
        read_all(*footage::open_source(folder / "huge.avi"));
    } catch (const Error& error) {
        EXPECT_TRUE(error.kind() == ErrorKind::limit || error.kind() == ErrorKind::not_video) << error.what();
    }
    rusage after{};
    ::getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 500'000) << "kilobytes";
}

/// Stdin from a file or a pipe while it lives.
class Stdin {
  public:
    explicit Stdin(int fd) : saved_(::dup(STDIN_FILENO)) {
        ::dup2(fd, STDIN_FILENO);
        ::close(fd);
    }
    ~Stdin() {
        ::dup2(saved_, STDIN_FILENO);
        ::close(saved_);
    }
    Stdin(const Stdin&) = delete;
    Stdin& operator=(const Stdin&) = delete;

  private:
    int saved_;
};

/// Pipes `bytes` to stdin while `use` runs.
void with_pipe(const std::string& bytes, const std::function<void()>& use) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    // A reader that gives up early closes the pipe under the writer.
    const auto old = std::signal(SIGPIPE, SIG_IGN);
    std::thread writer([&] {
        std::size_t sent = 0;
        while (sent < bytes.size()) {
            const auto put = ::write(ends[1], bytes.data() + sent, bytes.size() - sent);
            if (put <= 0) break;
            sent += static_cast<std::size_t>(put);
        }
        ::close(ends[1]);
    });
    {
        const Stdin replaced(ends[0]);
        use();
    }
    writer.join();
    std::signal(SIGPIPE, old);
}

TEST_F(VideoErrors, APipeGivesTheSameAsTheFile) {
    // The index of this one is at its end: a pipe that isn't spooled can't reach it.
    const auto clip = walkers_clip(folder, "clip.mp4", "-c:v libx264 -bf 2");
    const auto whole = fingerprint(read_all(*footage::open_source(clip)));
    with_pipe(read_bytes(clip), [&] {
        const auto source = footage::open_source("-");
        EXPECT_EQ(source->info().name, "-");
        EXPECT_EQ(fingerprint(read_all(*source)), whole);
        EXPECT_GT(source->sample(5).size(), 1u);
        EXPECT_EQ(fingerprint(read_all(*source)), whole);
    });
    const Stdin redirected(::open(clip.c_str(), O_RDONLY));
    EXPECT_EQ(fingerprint(read_all(*footage::open_source("-"))), whole);
}

TEST_F(VideoErrors, ANamedPipeIsSpooled) {
    const auto clip = walkers_clip(folder, "clip.mp4", "-c:v libx264 -bf 2");
    const auto fifo = folder / "fifo";
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    std::thread writer([&] { write_bytes(fifo, read_bytes(clip)); });
    EXPECT_EQ(read_all(*footage::open_source(fifo)).size(), 75u);
    writer.join();
}

TEST_F(VideoErrors, NoRoomForThePipe) {
    const auto old = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit small{1 << 20, limit.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    with_pipe(std::string(3 << 20, 'x'), [] {
        expect_open_error("-", ErrorCode::disk_full, {"'-'", "after 1.0 MB", "File too large", "TMPDIR"});
    });
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, old);
}

}  // namespace
}  // namespace vvr
