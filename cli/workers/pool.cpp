#include "cli/workers/pool.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/error.h"

namespace vvr::workers {

namespace {

using namespace std::chrono_literals;

constexpr auto patience = 800ms;  // with workers that are asked to end

}  // namespace

WorkerPool::WorkerPool(int most, cli::Signals& signals)
    : most_(most), signals_(signals), wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    if (wake_ < 0) {
        throw Error(ErrorKind::limit, fmt::format("cannot wait for workers: {}; allow the program more open files",
                                                  std::generic_category().message(errno)));
    }
    signals_.set_exit_hook([this] {
        ending_ = true;
        ::eventfd_write(wake_, 1);
        for (auto waited = std::chrono::milliseconds::zero(); !ended_ && waited < 2 * patience; waited += 10ms)
            std::this_thread::sleep_for(10ms);
    });
}

WorkerPool::~WorkerPool() {
    // A signal that came just now waits for the workers, and would wait for this thread in vain.
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
        if (over.empty()) sleep();
    }
}

void WorkerPool::sleep() const {
    std::vector<pollfd> waits{{wake_, POLLIN, 0}};
    bool closed = false;
    for (const Job& job : jobs_) {
        pollfd wait{job.worker->descriptor(), POLLIN, 0};
        // One that has closed its stderr is about to end, and there is nothing more to wait on.
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
    while (!jobs_.empty() && std::chrono::steady_clock::now() - begin < patience) {
        std::erase_if(jobs_, [](const Job& job) { return job.worker->update(); });
        std::this_thread::sleep_for(5ms);
    }
    jobs_.clear();
    ended_ = true;
    for (;;) ::pause();  // the signal ends the program
}

}  // namespace vvr::workers
