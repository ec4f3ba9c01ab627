#include "cli/console.h"

#include "cli/report_errors.h"

namespace vvr::cli {

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
