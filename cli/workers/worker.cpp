#include "cli/workers/worker.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/error.h"

namespace vvr {

namespace {

constexpr std::size_t most_said = 4096;  // the end is what counts: errors come last
constexpr std::string_view no_walls = "vvr: the system lets no worker into its sandbox; try --sandbox off\n";

[[noreturn]] void refuse(const char* what, int error) {
    throw Error(ErrorKind::limit, fmt::format("cannot start a worker: {}: {}; try fewer --jobs", what,
                                              std::generic_category().message(error)));
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    pointers.reserve(texts.size() + 1);
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// The environment, in which Mesa's software rasteriser reads how many threads it may have.
std::vector<std::string> environment_for(int threads) {
    constexpr std::string_view rasteriser_threads = "LP_NUM_THREADS=";
    std::vector<std::string> variables;
    bool decided = false;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        decided = decided || std::string_view(*variable).starts_with(rasteriser_threads);
        variables.emplace_back(*variable);
    }
    // 0 = the thread that asks does it itself.
    if (!decided) variables.push_back(fmt::format("{}{}", rasteriser_threads, threads > 1 ? threads : 0));
    return variables;
}

/// What happens between fork and exec: only calls that may stand there in a program with threads.
struct Birth {
    pid_t parent;
    int output;
    int nothing;
    int inherited;
    std::int64_t memory;
    const Confinement& walls;
    char* const* arguments;
    char* const* environment;

    [[noreturn]] void run() const {
        ::setpgid(0, 0);
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != parent) ::_exit(127);
        ::dup2(nothing, STDIN_FILENO);
        ::dup2(nothing, STDOUT_FILENO);
        ::dup2(output, STDERR_FILENO);
        if (inherited >= 0) ::fcntl(inherited, F_SETFD, 0);
        if (memory > 0) {
            // What is allocated counts, not address space: drivers reserve much more of that than they use.
            const rlimit limit{static_cast<rlim_t>(memory), static_cast<rlim_t>(memory)};
            ::setrlimit(RLIMIT_DATA, &limit);
        }
        const rlimit none{0, 0};
        ::setrlimit(RLIMIT_CORE, &none);
        sigset_t open;
        sigemptyset(&open);
        ::sigprocmask(SIG_SETMASK, &open, nullptr);
        // Now, and not in the worker: libraries start threads before main, and Landlock holds for the one that asks.
        if (!walls.enter()) {
            [[maybe_unused]] const ssize_t told = ::write(STDERR_FILENO, no_walls.data(), no_walls.size());
            ::_exit(127);
        }
        ::execve("/proc/self/exe", arguments, environment);
        ::_exit(127);
    }
};

}  // namespace

Worker::Worker(const std::vector<std::string>& arguments, int threads, const WorkerLimits& limits, int inherited,
               const Confinement& walls)
    : limits_(limits) {
    std::vector<std::string> texts{"vvr"};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<std::string> variables = environment_for(threads);
    const std::vector<char*> argument_pointers = pointers_to(texts);
    const std::vector<char*> variable_pointers = pointers_to(variables);
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC | O_NONBLOCK) != 0) refuse("pipe", errno);
    ::fcntl(pipe[1], F_SETFL, 0);
    const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    const Birth birth{::getpid(),
                      pipe[1],
                      nothing,
                      inherited,
                      limits.memory,
                      walls,
                      argument_pointers.data(),
                      variable_pointers.data()};
    process_ = ::fork();
    if (process_ == 0) birth.run();
    const int error = errno;
    ::close(pipe[1]);
    ::close(nothing);
    output_ = pipe[0];
    if (process_ < 0) {
        ::close(output_);
        refuse("fork", error);
    }
    ::setpgid(process_, process_);  // as the child does: whoever comes first
}

Worker::~Worker() {
    if (!ended_) {
        ::kill(-process_, SIGKILL);
        reap(true);
    }
    ::close(output_);
}

bool Worker::update() {
    read_output();
    reap(false);
    if (!ended_ && limits_.time.count() > 0 && !end_.timed_out && Clock::now() - began_ > limits_.time) {
        end_.timed_out = true;
        ::kill(-process_, SIGKILL);
    }
    if (ended_) read_output();
    return ended_;
}

void Worker::interrupt() {
    if (!ended_) ::kill(-process_, SIGTERM);
}

void Worker::read_output() {
    std::array<char, 4096> room{};
    for (;;) {
        const ssize_t count = ::read(output_, room.data(), room.size());
        if (count <= 0) return;
        end_.said.append(room.data(), static_cast<std::size_t>(count));
        if (end_.said.size() > most_said) end_.said.erase(0, end_.said.size() - most_said);
    }
}

void Worker::reap(bool wait) {
    int status = 0;
    pid_t ended = 0;
    do ended = ::waitpid(process_, &status, wait ? 0 : WNOHANG);
    while (ended < 0 && errno == EINTR);
    if (ended != process_) return;
    ended_ = true;
    end_.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    end_.seconds = std::chrono::duration<double>(Clock::now() - began_).count();
}

}  // namespace vvr
