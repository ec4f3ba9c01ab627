#include "cli/workers/worker.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <string_view>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"

namespace vvr::workers {

namespace {

constexpr std::size_t most_kept = 4096;  // keep the end: errors come last

[[noreturn]] void refuse(const char* what, int error) {
    throw Error(ErrorCode::worker_start_failed,
                fmt::format("cannot start a worker: {}: {}; try fewer --jobs", what, text_of_system_error(error)));
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    pointers.reserve(texts.size() + 1);
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// The child's environment: worker_variable tells vvr that it is a worker. The user's own variables win over ours.
std::vector<std::string> environment_for(int threads, const std::string& worker) {
    std::map<std::string, std::string> variables;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text = *variable;
        const std::size_t end = text.find('=');
        if (end != std::string_view::npos) variables.emplace(text.substr(0, end), text.substr(end + 1));
    }
    // Threads of Mesa's software rasteriser; 0 = the calling thread does all the work.
    variables.emplace("LP_NUM_THREADS", std::to_string(threads > 1 ? threads : 0));
    variables[std::string(worker_variable)] = worker;
    std::vector<std::string> texts;
    for (const auto& [name, value] : variables) texts.push_back(fmt::format("{}={}", name, value));
    return texts;
}

/// A pipe from a worker to its parent. The parent's end doesn't block.
struct Pipe {
    Pipe() : Pipe(ends()) {}
    explicit Pipe(const std::array<int, 2>& both) : out(both[0]), in(both[1]) {}

    static std::array<int, 2> ends() {
        std::array<int, 2> both{};
        if (::pipe2(both.data(), O_CLOEXEC | O_NONBLOCK) != 0) refuse("pipe", errno);
        ::fcntl(both[1], F_SETFL, 0);
        return both;
    }

    Descriptor out;
    Descriptor in;
};

/// A memory file that holds a plan, positioned at its start. A pipe would have room for the plan of a short day only.
Descriptor file_of(const WorkerPlan& plan) {
    const std::string bytes = encode(plan);
    Descriptor file(::memfd_create("vvr-plan", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (file.get() < 0) refuse("memfd_create", errno);
    for (std::string_view left = bytes; !left.empty();) {
        const ssize_t written = ::write(file.get(), left.data(), left.size());
        if (written < 0) refuse("write", errno);
        left.remove_prefix(static_cast<std::size_t>(written));
    }
    ::lseek(file.get(), 0, SEEK_SET);
    // The worker inherits the file as its stdin. Without seals, it could grow the file past its limits on memory.
    if (::fcntl(file.get(), F_ADD_SEALS, F_SEAL_WRITE | F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL) != 0)
        refuse("fcntl", errno);
    return file;
}

/// What happens between fork and exec. It makes only async-signal-safe calls, as the program has threads.
struct ChildSetup {
    pid_t parent;
    int plan;
    int output;
    int nothing;
    int message;
    int inherited;
    const WorkerLimits& limits;
    const Confinement& confinement;
    char* const* arguments;
    char* const* environment;

    /// Lowers a limit; never raises one that this process already has.
    static void allow_at_most(__rlimit_resource what, std::int64_t most) {
        rlimit limit{};
        if (::getrlimit(what, &limit) != 0) return;
        limit.rlim_cur = limit.rlim_max = std::min({limit.rlim_cur, limit.rlim_max, static_cast<rlim_t>(most)});
        ::setrlimit(what, &limit);
    }

    [[noreturn]] void run() const {
        ::setpgid(0, 0);
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != parent) ::_exit(not_begun_status);
        ::dup2(plan, STDIN_FILENO);
        ::dup2(nothing, STDOUT_FILENO);
        ::dup2(output, STDERR_FILENO);
        ::fcntl(message, F_SETFD, 0);
        if (inherited >= 0) ::fcntl(inherited, F_SETFD, 0);
#ifndef __SANITIZE_ADDRESS__  // which reserves more memory than any limit allows
        // RLIMIT_DATA, not RLIMIT_AS: drivers reserve far more address space than they use.
        if (limits.memory > 0) allow_at_most(RLIMIT_DATA, limits.memory);
#endif
        if (limits.file > 0) allow_at_most(RLIMIT_FSIZE, limits.file);
        allow_at_most(RLIMIT_CORE, 0);
        sigset_t open;
        sigemptyset(&open);
        ::sigprocmask(SIG_SETMASK, &open, nullptr);
        // Must happen before exec: libraries start threads before main, and Landlock applies to the calling thread
        // only.
        if (!confinement.enter()) {
            [[maybe_unused]] const ssize_t written =
                ::write(STDERR_FILENO, no_sandbox_text.data(), no_sandbox_text.size());
            ::_exit(not_begun_status);
        }
        ::execve("/proc/self/exe", arguments, environment);
        ::_exit(not_begun_status);
    }
};

}  // namespace

Worker::Worker(const WorkerPlan& plan, int threads, const WorkerLimits& limits, int inherited,
               const Confinement& confinement)
    : limits_(limits) {
    // The worker reads only the plan; `ps` shows these arguments.
    std::vector<std::string> texts{"vvr", plan.command};
    if (!plan.inputs.empty()) texts.push_back(plan.inputs.front());
    Pipe said;
    Pipe message;
    const Descriptor plan_file = file_of(plan);
    std::vector<std::string> variables =
        environment_for(threads, worker_value(message.in.get(), confinement.filters_calls()));
    const std::vector<char*> argument_pointers = pointers_to(texts);
    const std::vector<char*> variable_pointers = pointers_to(variables);
    const Descriptor nothing(::open("/dev/null", O_RDWR | O_CLOEXEC));
    const ChildSetup child{::getpid(),
                           plan_file.get(),
                           said.in.get(),
                           nothing.get(),
                           message.in.get(),
                           inherited,
                           limits,
                           confinement,
                           argument_pointers.data(),
                           variable_pointers.data()};
    process_ = ::fork();
    if (process_ == 0) child.run();
    if (process_ < 0) refuse("fork", errno);
    output_ = said.out.release();
    message_pipe_ = message.out.release();
    ::setpgid(process_, process_);  // parent and child both call it, to avoid a race
}

Worker::~Worker() {
    if (!ended_) {
        kill();
        reap(true);
    }
    ::close(output_);
    ::close(message_pipe_);
}

/// Kills the process too, as without a sandbox it may have left its group.
void Worker::kill() const {
    ::kill(-process_, SIGKILL);
    ::kill(process_, SIGKILL);
}

bool Worker::update() {
    read_output();
    read_message();
    reap(false);
    if (!ended_) enforce_limits();
    if (ended_) read_output();
    return ended_;
}

void Worker::enforce_limits() {
    if (end_.timed_out || end_.wrote_too_much) return;
    end_.timed_out = limits_.time.count() > 0 && Clock::now() - began_ > limits_.time;
    end_.wrote_too_much = !end_.timed_out && limits_.written > 0 && written() > limits_.written;
    if (end_.timed_out || end_.wrote_too_much) kill();
}

/// Bytes written in total, as the kernel counts them.
std::int64_t Worker::written() const {
    std::ifstream counts(fmt::format("/proc/{}/io", process_));
    std::string name;
    std::int64_t bytes = 0;
    while (counts >> name >> bytes) {
        if (name == "wchar:") return bytes;
    }
    return 0;
}

void Worker::interrupt() {
    if (!ended_) ::kill(-process_, SIGTERM);
}

void Worker::read_output() {
    std::array<char, 4096> room{};
    constexpr int most_reads = 64;  // per update: a worker that writes without end must not hold up the others
    for (int reads = 0; reads < most_reads; ++reads) {
        const ssize_t count = ::read(output_, room.data(), room.size());
        if (count <= 0) return;
        end_.stderr_end.append(room.data(), static_cast<std::size_t>(count));
        if (end_.stderr_end.size() > most_kept) end_.stderr_end.erase(0, end_.stderr_end.size() - most_kept);
    }
}

/// Reads the pipe: one byte when the worker has begun, then its message when it ends. A pipe may have room for a part
/// of the message only.
void Worker::read_message() {
    std::array<char, 4096> room{};
    while (message_.size() <= longest_message + most_marks) {
        const ssize_t count = ::read(message_pipe_, room.data(), room.size());
        if (count <= 0) return;
        message_.append(room.data(), static_cast<std::size_t>(count));
    }
}

/// The number of marks of progress, which follow the first byte.
std::size_t Worker::marks() const {
    if (message_.empty()) return 0;
    const std::size_t end = message_.find_first_not_of(progress_mark, 1);
    return std::min(end, message_.size()) - 1;
}

double Worker::progress() const {
    return std::min(1.0, static_cast<double>(marks()) / most_marks);
}

void Worker::reap(bool wait) {
    int status = 0;
    pid_t ended = 0;
    do ended = ::waitpid(process_, &status, wait ? 0 : WNOHANG);
    while (ended < 0 && errno == EINTR);
    if (ended != process_) return;
    ended_ = true;
    read_message();
    end_.began = !message_.empty();
    end_.message = decode_message(std::string_view(message_).substr(std::min(1 + marks(), message_.size())));
    end_.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    end_.seconds = std::chrono::duration<double>(Clock::now() - began_).count();
}

namespace {

using namespace std::chrono_literals;

constexpr auto grace = 800ms;  // how long workers have to end after SIGTERM

}  // namespace

WorkerPool::WorkerPool(int most, cli::Signals& signals)
    : most_(most), signals_(signals), wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    if (wake_ < 0) {
        throw Error(ErrorCode::worker_start_failed,
                    fmt::format("cannot wait for workers: {}; raise the limit of open files (ulimit -n)",
                                text_of_system_error(errno)));
    }
    signals_.set_exit_hook([this] {
        ending_ = true;
        ::eventfd_write(wake_, 1);
        for (auto waited = std::chrono::milliseconds::zero(); !ended_ && waited < 2 * grace; waited += 10ms)
            std::this_thread::sleep_for(10ms);
    });
}

WorkerPool::~WorkerPool() {
    // If a signal arrived just now, its handler waits for the workers to end and would block this thread.
    if (ending_) end_all();
    signals_.set_exit_hook({});
    ::close(wake_);
}

void WorkerPool::add(std::unique_ptr<Worker> worker, Done done) {
    jobs_.push_back({std::move(worker), std::move(done)});
}

void WorkerPool::wait_until_below(int count) {
    for (;;) {
        if (ending_) end_all();
        std::list<Job> over;
        for (auto job = jobs_.begin(); job != jobs_.end();) {
            const auto next = std::next(job);
            if (job->worker->update()) over.splice(over.end(), jobs_, job);
            job = next;
        }
        for (const Job& job : over) job.done(job.worker->end());
        if (std::ssize(jobs_) < count) return;
        if (tick_) tick_();
        if (over.empty()) sleep();
    }
}

void WorkerPool::sleep() const {
    std::vector<pollfd> waits{{wake_, POLLIN, 0}};
    bool closed = false;
    for (const Job& job : jobs_) {
        pollfd wait{job.worker->descriptor(), POLLIN, 0};
        // A worker that has closed its stderr is about to end; poll() would return for it at once.
        if (::poll(&wait, 1, 0) > 0 && (wait.revents & POLLHUP) != 0) {
            closed = true;
        } else {
            waits.push_back(wait);
        }
    }
    ::poll(waits.data(), waits.size(), closed ? 2 : 250);
}

void WorkerPool::end_all() {
    for (const Job& job : jobs_) job.worker->interrupt();
    const auto begin = std::chrono::steady_clock::now();
    while (!jobs_.empty() && std::chrono::steady_clock::now() - begin < grace) {
        std::erase_if(jobs_, [](const Job& job) { return job.worker->update(); });
        std::this_thread::sleep_for(5ms);
    }
    jobs_.clear();
    ended_ = true;
    for (;;) ::pause();  // the signal ends the program
}

}  // namespace vvr::workers
