#include "cli/workers/archive_progress.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include <sys/ioctl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/archive/output_files.h"
#include "core/base/text.h"

namespace vvr::workers {

namespace {

/// The columns of the terminal on stderr.
std::size_t columns_of_terminal() {
    constexpr std::size_t usual = 80;
    winsize size{};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

/// The beginning of a text that fits into a line. Characters beyond ASCII may be two columns wide.
std::string cut(std::string_view text, std::size_t columns) {
    std::string line;
    std::size_t width = 0;
    while (!text.empty()) {
        const std::optional<Character> character = first_character(text);
        const std::size_t length = character ? character->length : 1;
        width += length > 1 ? 2 : 1;
        if (width > columns) break;
        line += text.substr(0, length);
        text.remove_prefix(length);
    }
    return line;
}

}  // namespace

std::string progress_text(const ArchiveProgress& progress, std::span<const ClipProgress> running, double seconds,
                          std::size_t columns) {
    double read = static_cast<double>(progress.finished_bytes);
    for (const ClipProgress& clip : running) read += clip.part * static_cast<double>(clip.bytes);
    std::string text = fmt::format(
        "{}; {} of {}",
        cli::progress_text("archive", std::llround(read), std::max<std::int64_t>(1, progress.bytes), seconds),
        progress.finished, counted(static_cast<std::int64_t>(progress.clips), "clip"));
    const char* separator = "; ";
    for (const ClipProgress& clip : running) {
        text += fmt::format("{}{} {}", separator, shown_text(archive::text_of_path(clip.name)),
                            clip.part < 1 ? fmt::format("{:.0f} %", 100 * clip.part) : "is drawn");
        separator = ", ";
    }
    return cut(text, columns);
}

ArchiveBar::ArchiveBar(const cli::Environment& environment) : shown_(!environment.quiet && cli::stderr_is_terminal()) {}

void ArchiveBar::show(const ArchiveProgress& progress, std::span<const ClipProgress> running) {
    if (!shown_ || Clock::now() < next_) return;
    next_ = Clock::now() + std::chrono::milliseconds(100);
    is_there_ = true;
    const std::chrono::duration<double> seconds = Clock::now() - begin_;
    const std::size_t columns = columns_of_terminal();
    cli::write_on_terminal(
        fmt::format("{}{}", cli::clear_line, progress_text(progress, running, seconds.count(), columns - 1)));
}

void ArchiveBar::clear() {
    if (is_there_) cli::write_on_terminal(cli::clear_line);
    is_there_ = false;
    next_ = {};
}

}  // namespace vvr::workers
