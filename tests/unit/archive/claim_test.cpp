#include <atomic>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/archive/prune.h"
#include "core/archive/sidecar.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/lock_file.h"
#include "tests/unit/archive/archive.h"

namespace vvr {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using test::Archive;

TEST_F(Archive, WaitsNoLongerForALockThanItMay) {
    const auto held = LockFile::try_take(out(), "index.html");
    EXPECT_THROW(LockFile::wait_for(out(), "index.html", 50ms), Error);
    EXPECT_NO_THROW(LockFile::wait_for(out(), "other.html", 50ms));
}

TEST_F(Archive, HasOneOwnerHoweverManyAsk) {
    std::atomic<int> owners = 0;
    std::atomic<int> shared = 0;
    std::atomic<int> taken = 0;
    const auto ask = [&] {
        for (int i = 0; i < 3000; ++i) {
            const auto lock = LockFile::try_take(out(), "a.avi");
            if (!lock) continue;
            ++taken;
            if (++owners > 1) ++shared;
            std::this_thread::yield();
            --owners;
        }
    };
    {
        std::vector<std::jthread> threads;
        for (int k = 0; k < 4; ++k) threads.emplace_back(ask);
    }
    EXPECT_GT(taken, 0);
    EXPECT_EQ(shared, 0);
}

TEST_F(Archive, IsClaimedByOneAtATime) {
    auto first = LockFile::try_take(out(), "a.avi");
    ASSERT_TRUE(first);
    EXPECT_FALSE(first->is_stale());
    EXPECT_FALSE(LockFile::try_take(out(), "a.avi"));
    EXPECT_TRUE(LockFile::try_take(out(), "b.avi"));
    const fs::path file = fs::directory_iterator(out())->path();
    EXPECT_TRUE(LockFile::is_lock_file(file));
    EXPECT_FALSE(LockFile::take_over(file));
    first.reset();
    EXPECT_TRUE(fs::is_empty(out())) << "a claim leaves no file";
    EXPECT_TRUE(LockFile::try_take(out(), std::string(255, 'a')));
    EXPECT_THROW(LockFile::try_take(out() / "none", "a"), Error);
}

TEST_F(Archive, TidiesAfterThoseWhoWereKilled) {
    const auto be_killed = [&] {
        const pid_t child = ::fork();
        if (child == 0) {
            const auto claim = LockFile::try_take(out(), "a.avi");
            ::_exit(claim ? 0 : 1);  // without a destructor, as SIGKILL would
        }
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        ASSERT_EQ(status, 0);
    };
    be_killed();
    write(out() / "a.avi.png");
    write(out() / "other.png");
    {
        const auto claim = LockFile::try_take(out(), "a.avi");
        ASSERT_TRUE(claim);
        EXPECT_TRUE(claim->is_stale());
        archive::tidy(out(), archive::list_outputs(out(), in()));
        EXPECT_TRUE(fs::exists(out() / "a.avi.png")) << "somebody is at it";
    }
    write(out() / "a.avi.html");
    fs::last_write_time(out() / "a.avi.html", fs::file_time_type::clock::now() - std::chrono::seconds(1));
    be_killed();
    write(out() / "a.avi.png");
    archive::tidy(out(), archive::list_outputs(out(), in()));
    EXPECT_FALSE(fs::exists(out() / "a.avi.png")) << "half of a clip's files that nobody will finish";
    EXPECT_TRUE(fs::exists(out() / "a.avi.html")) << "from before that run: a complete one made it";
    EXPECT_TRUE(fs::exists(out() / "other.png"));
    EXPECT_EQ(std::distance(fs::directory_iterator(out()), {}), 2);
}

TEST_F(Archive, RemovesNoClipThatHasBeenDrawnSince) {
    archive::Sidecar sidecar = done("a.avi");
    archive::write_sidecar(out(), sidecar);
    const archive::Sidecar known = archive::list_outputs(out(), in()).sidecars.front();
    sidecar.clip.modified += 1;
    archive::write_sidecar(out(), sidecar);
    EXPECT_FALSE(archive::remove_clip(out(), in(), known));
    EXPECT_TRUE(fs::exists(out() / "a.avi.png"));
    EXPECT_TRUE(archive::remove_clip(out(), in(), sidecar));
    EXPECT_FALSE(fs::exists(out() / "a.avi.png"));
    EXPECT_FALSE(archive::remove_clip(out(), in(), sidecar)) << "another run has removed it";
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
        EXPECT_TRUE(LockFile::is_lock_file(file));
        EXPECT_FALSE(LockFile::take_over(file)) << file;
        EXPECT_TRUE(fs::exists(file)) << file;
    }
    archive::tidy(out(), archive::list_outputs(out(), in()));
    EXPECT_TRUE(fs::exists(out() / "victim/photo.png"));
    EXPECT_TRUE(fs::exists(out() / "photo.png"));
    EXPECT_TRUE(LockFile::take_over(leave_claim("good", "good")));
}

}  // namespace
}  // namespace vvr
