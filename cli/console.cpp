#include "cli/console.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>

#include "cli/exit_status.h"
#include "core/annotation/time_ticks.h"
#include "core/base/file.h"

namespace vvr::cli {

void print(std::string_view text) {
    write_standard_output(std::as_bytes(std::span(text)));
}

void write_on_terminal(std::string_view text) {
    // Ignore write errors: the run goes on without its terminal.
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

std::string progress_text(std::string_view what, std::int64_t done, std::int64_t total, double seconds) {
    if (total <= 0) return fmt::format("{} {}", what, done);
    constexpr std::int64_t width = 20;
    constexpr double soon = 2;  // seconds: earlier, a rate says little
    const double part = std::clamp(static_cast<double>(done) / static_cast<double>(total), 0.0, 1.0);
    const auto filled = static_cast<std::int64_t>(width * part);
    std::string text = fmt::format("{} [{:=<{}}{:{}}] {:.0f} %", what, "", filled, "", width - filled, 100 * part);
    if (seconds >= soon && part > 0 && part < 1)
        text += fmt::format(", {} left", annotation::format_duration(std::ceil(seconds * (1 - part) / part)));
    return text;
}

Progress::Progress(std::string what) : what_(std::move(what)) {}

Progress::~Progress() {
    write_on_terminal(clear_line);
}

void Progress::set(std::int64_t done, std::int64_t total) {
    if (Clock::now() < next_) return;
    next_ = Clock::now() + std::chrono::milliseconds(100);
    const std::chrono::duration<double> seconds = Clock::now() - begin_;
    write_on_terminal(fmt::format("{}{}", clear_line, progress_text(what_, done, total, seconds.count())));
}

bool stderr_is_terminal() {
    const char* terminal = std::getenv("TERM");
    return ::isatty(STDERR_FILENO) == 1 && (terminal == nullptr || std::string_view(terminal) != "dumb");
}

Console::Console(const Environment& environment, bool bar)
    : environment_(environment), bar_(bar && !environment.quiet && stderr_is_terminal()) {}

void Console::frames(std::int64_t done, std::int64_t expected) {
    const std::lock_guard lock(mutex_);
    if (environment_.progress && expected > 0)
        environment_.progress(static_cast<double>(done) / static_cast<double>(expected));
    if (!bar_) return;
    show("frames", done, expected);
}

void Console::drawing(std::int64_t done, std::int64_t parts) {
    const std::lock_guard lock(mutex_);
    if (bar_) show("drawing", done, parts);
}

void Console::show(std::string_view what, std::int64_t done, std::int64_t total) {
    if (!progress_ || progress_->what() != what) progress_.emplace(std::string(what));
    progress_->set(done, total);
}

void Console::clear() {
    const std::lock_guard lock(mutex_);
    progress_.reset();
}

void Console::debug(const std::string& text) {
    clear();
    environment_.log.debug("{}", text);
}

void Console::info(const std::string& text) {
    clear();
    environment_.log.info("{}", text);
}

void Console::warn(const std::string& text, const RelatedSettings& about) {
    clear();
    environment_.log.warn("{}", with_flags(text, about));
}

std::unique_lock<std::mutex> Console::guard() {
    return environment_.signals.hold();
}

}  // namespace vvr::cli
