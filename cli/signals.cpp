#include "cli/signals.h"

#include <chrono>
#include <initializer_list>

#include <pthread.h>

namespace vvr::cli {

namespace {

bool ignored(int signal) {
    struct sigaction action {};
    return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

Signals::Signals() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    sigemptyset(&set_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        if (!ignored(signal)) sigaddset(&set_, signal);
    }
    // Threads inherit the signal mask, so from now on only the waiter receives these signals.
    pthread_sigmask(SIG_BLOCK, &set_, nullptr);
    waiter_ = std::jthread([this](const std::stop_token& stop) { wait(stop); });
}

Signals::~Signals() {
    waiter_.request_stop();
    // The waiter is blocked in sigwait; send it one of its signals.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        if (sigismember(&set_, signal) == 1) {
            pthread_kill(waiter_.native_handle(), signal);
            break;
        }
    }
}

void Signals::set_stop_handler(std::function<void()> stop) {
    const std::lock_guard lock(stopping_);
    stop_ = std::move(stop);
}

bool Signals::stop_gracefully() {
    const std::lock_guard lock(stopping_);
    if (!stop_) return false;
    std::exchange(stop_, nullptr)();
    return true;
}

void Signals::set_exit_hook(std::function<void()> exit_hook) {
    const std::scoped_lock alone(ending_);
    exit_hook_ = std::move(exit_hook);
}

void run_stoppable(Signals& signals, const std::function<bool(const std::stop_token& stop)>& work) {
    const std::stop_source stop;
    signals.set_exit_hook([stop]() mutable { stop.request_stop(); });
    if (!work(stop.get_token())) {
        // A signal has stopped it, and is about to end the program.
        for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
    }
    signals.set_exit_hook({});
}

void Signals::wait(const std::stop_token& stop) {
    int signal = 0;
    do {
        if (sigwait(&set_, &signal) != 0 || stop.stop_requested()) return;
    } while (stop_gracefully());
    {
        const std::scoped_lock alone(ending_);
        if (exit_hook_) exit_hook_();
    }
    const auto nothing_half_written = hold();
    std::signal(signal, SIG_DFL);
    // Unblock only this signal: another one may be pending from the destructor.
    sigset_t this_one{};
    sigemptyset(&this_one);
    sigaddset(&this_one, signal);
    pthread_sigmask(SIG_UNBLOCK, &this_one, nullptr);
    std::raise(signal);
}

}  // namespace vvr::cli
