#include "cli/workers/sandbox.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <functional>
#include <string>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace vvr {
namespace {

namespace fs = std::filesystem;

constexpr int never_tried = 255;

/// The error that a call meets in a child which has shut itself in; 0 = none.
int error_behind(const std::function<bool()>& shut_in, const std::function<long()>& call) {
    const pid_t child = ::fork();
    if (child == 0) {
        const bool confined = ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && shut_in();
        ::_exit(!confined ? never_tried : call() < 0 ? errno : 0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : never_tried;
}

/// A folder with a file that may be read, one that may not, and a folder to write into.
class Files : public testing::Test {
  protected:
    Files() {
        fs::create_directory(path("out"));
        for (const char* const name : {"mine", "other", "out/old"}) test::write_bytes(path(name), "text");
    }

    std::string path(const char* name) const { return folder_ / name; }

    static long open(const std::string& path, int flags) { return ::open(path.c_str(), flags | O_CLOEXEC, 0600); }

  private:
    test::TempFolder folder_;
};

TEST_F(Files, EachVersionOfLandlockKeepsThem) {
    const int newest = workers::find_landlock().abi;
    if (newest == 0) GTEST_SKIP() << "this kernel has no Landlock";
    for (int abi = 1; abi <= newest; ++abi) {
        SCOPED_TRACE(abi);
        workers::LandlockRules rules(abi);
        rules.allow(path("mine"), workers::Use::read);
        rules.allow(path("out"), workers::Use::write);
        rules.allow(path("is not there"), workers::Use::read);
        const auto met = [&](const std::function<long()>& call) {
            return error_behind([&] { return rules.enforce(); }, call);
        };
        EXPECT_EQ(met([&] { return open(path("mine"), O_RDONLY); }), 0);
        EXPECT_EQ(met([&] { return open(path("mine"), O_WRONLY); }), EACCES);
        EXPECT_EQ(met([&] { return open(path("other"), O_RDONLY); }), EACCES);
        EXPECT_EQ(met([&] { return open(path("new"), O_WRONLY | O_CREAT); }), EACCES);
        EXPECT_EQ(met([&] { return open(path("out/new"), O_WRONLY | O_CREAT); }), 0);
        EXPECT_EQ(met([&] { return open(path("out/old"), O_RDONLY); }), EACCES);
        EXPECT_EQ(met([&] { return ::rename(path("out/new").c_str(), path("out/newer").c_str()); }), 0);
        EXPECT_EQ(met([&] { return ::rename(path("out/newer").c_str(), path("newer").c_str()); }) != 0, true);
        EXPECT_EQ(met([&] { return ::unlink(path("out/newer").c_str()); }), 0);
        EXPECT_EQ(met([&] { return ::unlink(path("other").c_str()); }), EACCES);
    }
}

TEST_F(Files, TheFilterTakesSocketsAndLeavesFiles) {
    if (workers::call_filter_error() != 0) GTEST_SKIP() << "this kernel has no seccomp filters";
    const workers::CallFilter filter(false);
    const auto met = [&](const std::function<long()>& call) {
        return error_behind([&] { return filter.enforce(); }, call);
    };
    EXPECT_EQ(met([] { return ::socket(AF_UNIX, SOCK_STREAM, 0); }), ENOSYS);
    EXPECT_EQ(met([] { return ::fork(); }), ENOSYS);
    EXPECT_EQ(met([&] { return ::truncate(path("other").c_str(), 0); }), ENOSYS);
    EXPECT_EQ(met([&] { return open(path("other"), O_RDONLY); }), 0);
    EXPECT_EQ(met([&] { return open(path("new"), O_WRONLY | O_CREAT); }), 0);
}

TEST(Sandbox, OffIsNone) {
    const workers::Sandbox off(workers::SandboxMode::off, {});
    EXPECT_TRUE(off.is_whole());
    const workers::Confinement confinement = off.around({"/nowhere"}, "/nowhere");
    EXPECT_EQ(error_behind([&] { return confinement.enter(); }, [] { return ::socket(AF_UNIX, SOCK_STREAM, 0); }), 0);
}

TEST(Sandbox, ItsSummaryTellsOfBothWalls) {
    const workers::Sandbox sandbox(workers::SandboxMode::automatic, {});
#ifdef __SANITIZE_ADDRESS__
    EXPECT_NE(sandbox.summary().find("no sandbox"), std::string::npos);
#else
    EXPECT_NE(sandbox.summary().find("Landlock"), std::string::npos);
    EXPECT_NE(sandbox.summary().find("seccomp"), std::string::npos);
    EXPECT_EQ(sandbox.is_whole(), workers::find_landlock().abi > 0 && workers::call_filter_error() == 0);
#endif
}

TEST(Sandbox, AGraphicsCardIsForThoseWhoUseOne) {
    const auto opens_cards = [](bool gpu) {
        return std::ranges::count(workers::program_files(gpu), fs::path("/dev/dri"), &workers::ProgramFile::path) > 0;
    };
    EXPECT_TRUE(opens_cards(true));
    EXPECT_FALSE(opens_cards(false));
}

}  // namespace
}  // namespace vvr
