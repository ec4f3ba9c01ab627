#include "cli/console.h"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <string_view>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>

#include "cli/exit_status.h"
#include "core/base/file.h"

namespace vvr::cli {

void print(std::string_view text) {
    write_standard_output(std::as_bytes(std::span(text)));
}

namespace {

constexpr std::string_view clear_line = "\r\033[K";

void write_stderr(std::string_view text) {
    // Ignore write errors: the run goes on without its terminal.
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

Progress::Progress(std::string what, std::int64_t total) : what_(std::move(what)), total_(total) {}

Progress::~Progress() {
    write_stderr(clear_line);
}

void Progress::set(std::int64_t done) {
    if (Clock::now() < next_) return;
    next_ = Clock::now() + std::chrono::milliseconds(100);
    if (total_ <= 0) {
        write_stderr(fmt::format("{}{} {}", clear_line, what_, done));
        return;
    }
    constexpr std::int64_t width = 30;
    const std::int64_t filled = std::min(width, width * done / total_);
    write_stderr(fmt::format("{}{} [{:=<{}}{:{}}] {}/{}", clear_line, what_, "", filled, "", width - filled, done,
                             std::max(done, total_)));
}

bool stderr_is_terminal() {
    const char* terminal = std::getenv("TERM");
    return ::isatty(STDERR_FILENO) == 1 && (terminal == nullptr || std::string_view(terminal) != "dumb");
}

Console::Console(const Environment& environment, bool bar)
    : environment_(environment), bar_(bar && !environment.quiet && stderr_is_terminal()) {}

void Console::frames(std::int64_t done, std::int64_t expected) {
    if (!bar_) return;
    const std::lock_guard lock(mutex_);
    if (!progress_) progress_.emplace("frames", expected);
    progress_->set(done);
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
