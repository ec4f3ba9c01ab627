#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/detector/detector.h"

namespace vvr::detector {

namespace {

constexpr int passed = 42;  // no library ends a program with it
constexpr int failed = 1;

[[noreturn]] void refuse(const char* call) {
    const int error = errno;
    throw Error(ErrorCode::limit,
                fmt::format("cannot try the detector's model in a child process: {}: {}; raise the limit of processes",
                            call, std::strerror(error)));
}

/// The two ends of a pipe, closed when it is destroyed.
class Pipe {
  public:
    Pipe() {
        if (::pipe2(ends_.data(), O_CLOEXEC) != 0) refuse("pipe");
    }
    ~Pipe() {
        ::close(ends_[0]);
        close_input();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    int out() const { return ends_[0]; }
    int in() const { return ends_[1]; }
    void close_input() {
        if (const int end = std::exchange(ends_[1], -1); end >= 0) ::close(end);
    }

  private:
    std::array<int, 2> ends_{};
};

void limit(decltype(RLIMIT_AS) what, rlim_t value) {
    struct rlimit now {};
    if (::getrlimit(what, &now) != 0) return;
    now.rlim_cur = std::min(value, now.rlim_max);
    ::setrlimit(what, &now);
}

/// Ends the child with its parent, and at the limits.
void limit_child(pid_t parent, const TrialLimits& limits) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(failed);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
        std::signal(signal, SIG_DFL);
    }
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CPU, static_cast<rlim_t>(limits.seconds));
#ifndef __SANITIZE_ADDRESS__  // which reserves more addresses than any limit allows
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const auto page = static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
    limit(RLIMIT_AS, pages * page + (static_cast<rlim_t>(limits.megabytes) << 20U));
#endif
    if (const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC); nothing >= 0) ::dup2(nothing, STDERR_FILENO);
}

void say(int pipe, std::string_view text) {
    constexpr std::size_t most = 1000;  // less than a pipe's room, so it never waits
    [[maybe_unused]] const ssize_t written = ::write(pipe, text.data(), std::min(text.size(), most));
}

[[noreturn]] void run_child(const std::function<void()>& action, int pipe) {
    int status = failed;
    try {
        action();
        status = passed;
    } catch (const std::bad_alloc&) {
        say(pipe, "it needs too much memory");
    } catch (const std::exception& error) {
        say(pipe, error.what());
    } catch (...) {
        say(pipe, "it throws an unknown exception");
    }
    ::_exit(status);  // without destructors and handlers of the parent
}

/// All that comes out of a pipe until its end, or nothing when the time is over.
std::optional<std::string> read_until_end(int pipe, std::chrono::seconds patience) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + patience;
    std::string text;
    while (true) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0) return std::nullopt;
        pollfd ready{pipe, POLLIN, 0};
        if (::poll(&ready, 1, static_cast<int>(left)) <= 0) continue;
        std::array<char, 1000> piece{};
        const ssize_t got = ::read(pipe, piece.data(), piece.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return text;
        text.append(piece.data(), static_cast<std::size_t>(got));
    }
}

std::string text_of_end(int status, const TrialLimits& limits) {
    if (!WIFSIGNALED(status)) return "it ends the program";
    if (WTERMSIG(status) == SIGXCPU) return fmt::format("it needs more than {} s for one image", limits.seconds);
    return fmt::format("it crashes OpenCV with signal {}", WTERMSIG(status));
}

}  // namespace

std::optional<std::string> failure_in_child(const std::function<void()>& action, const TrialLimits& limits) {
    Pipe pipe;
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child < 0) refuse("fork");
    if (child == 0) {
        limit_child(parent, limits);
        run_child(action, pipe.in());
    }
    pipe.close_input();
    const auto text = read_until_end(pipe.out(), std::chrono::seconds(limits.clock_seconds));
    if (!text) ::kill(child, SIGKILL);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!text) return fmt::format("it hangs: no answer for {} s", limits.clock_seconds);
    if (WIFEXITED(status) && WEXITSTATUS(status) == passed) return std::nullopt;
    return text->empty() ? text_of_end(status, limits) : *text;
}

}  // namespace vvr::detector
