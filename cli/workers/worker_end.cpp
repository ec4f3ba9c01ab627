#include "cli/workers/worker_end.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <fmt/format.h>

#include "cli/exit_status.h"
#include "core/base/text.h"

namespace vvr::workers {

namespace {

namespace fs = std::filesystem;

constexpr int killed = 128;  // plus the signal number, as in a shell

/// Free bytes without which the next clip would fail too.
constexpr std::int64_t least_room = 16'000'000;

/// Why no file can be written to a folder, as in errno; 0 = it can. The test file has no name, so it leaves nothing
/// behind.
int disk_full_reason(const fs::path& folder) {
    const int file = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
    if (file >= 0) {
        const int error = ::posix_fallocate(file, 0, least_room);
        ::close(file);
        return error;
    }
    if (errno != EOPNOTSUPP && errno != EISDIR && errno != ENOENT) return errno;
    struct statvfs space {};
    if (::statvfs(folder.c_str(), &space) != 0) return 0;
    const bool full = space.f_bavail * space.f_frsize < static_cast<std::uint64_t>(least_room);
    return full || (space.f_files > 0 && space.f_favail == 0) ? ENOSPC : 0;
}

/// The ` [code]` that ends an error line.
struct CodeMark {
    std::size_t begin = std::string::npos;
    std::optional<ErrorCode> code{};
};

CodeMark mark_of_code(std::string_view line) {
    line = line.substr(0, line.find_last_not_of(' ') + 1);
    const std::size_t begin = line.rfind(" [");
    if (begin == std::string_view::npos || !line.ends_with(']')) return {};
    const auto code = find_error_code(line.substr(begin + 2, line.size() - begin - 3));
    return code ? CodeMark{begin, code} : CodeMark{};
}

}  // namespace

std::string error_text_of(const WorkerResult& end) {
    if (!end.message.text.empty()) return end.message.text;
    // The process may not have become vvr yet, or a library may have ended it. Keep all lines of the last error.
    constexpr std::string_view own = "vvr: ";
    std::size_t begin = end.stderr_end.starts_with(own) ? 0 : std::string::npos;
    if (const auto later = end.stderr_end.rfind("\nvvr: "); later != std::string::npos) begin = later + 1;
    std::string words =
        one_line(begin == std::string::npos ? end.stderr_end : end.stderr_end.substr(begin + own.size()));
    return words.substr(0, mark_of_code(words).begin);
}

std::string reason_of(const WorkerResult& end, const WorkerLimits& limits) {
    const std::string words = error_text_of(end);
    if (end.timed_out) {
        return fmt::format("it took longer than the limit of {} s (--timeout)", limits.time.count());
    }
    if (end.wrote_too_much) {
        return fmt::format("it wrote more than the limit of {} MB for a worker", limits.written / 1'000'000);
    }
    if (end.status > killed) {
        const int signal = end.status - killed;
        return fmt::format(
            "the worker was ended by signal {} ({}), because of a bug or of the limit on its memory, {} MB "
            "(--max-memory){}{}",
            signal, ::strsignal(signal), limits.memory / 1'000'000, words.empty() ? "" : ": ", words);
    }
    if (end.status == static_cast<int>(cli::ExitStatus::limit)) {
        return fmt::format("{}; the limit for a worker is {} MB (--max-memory)", words, limits.memory / 1'000'000);
    }
    return words.empty() ? fmt::format("the worker ended with status {} and without an error message", end.status)
                         : words;
}

void throw_if_system_fault(const std::string& clip, const fs::path& folder, const WorkerResult& end) {
    if (end.timed_out || end.wrote_too_much) return;
    if (!end.began && end.status < killed) {
        const std::string words = error_text_of(end);
        throw Error(
            ErrorCode::worker_start_failed,
            fmt::format("cannot start the worker for '{}'{}", clip,
                        words.empty() ? "; check that the program's file still exists, and that /proc is mounted"
                                      : ": " + words));
    }
    if (end.status != static_cast<int>(cli::ExitStatus::io)) return;
    const int error = disk_full_reason(folder);
    if (code_of_system_error(error) != ErrorCode::disk_full) return;
    throw system_error(error, fmt::format("cannot write to '{}'", folder.string()),
                       "free some space or choose another folder");
}

bool is_not_whole(const WorkerResult& end) {
    return end.status == static_cast<int>(cli::ExitStatus::partial);
}

bool failed(const WorkerResult& end) {
    return (end.status != 0 && !is_not_whole(end)) || end.timed_out || end.wrote_too_much;
}

int status_of(const WorkerResult& end) {
    if (end.timed_out || end.wrote_too_much) return static_cast<int>(cli::ExitStatus::limit);
    return end.status == 0 || is_not_whole(end) ? static_cast<int>(cli::ExitStatus::io) : end.status;
}

ErrorCode code_of(const WorkerResult& end) {
    if (end.timed_out) return ErrorCode::worker_timeout;
    if (end.wrote_too_much) return ErrorCode::worker_output_limit;
    if (end.status > killed) return ErrorCode::worker_killed;
    const auto code = end.message.code ? end.message.code : mark_of_code(one_line(end.stderr_end)).code;
    if (code && static_cast<int>(cli::exit_status(row_of(*code).kind)) == end.status) return *code;
    return cli::code_of_status(end.status).value_or(ErrorCode::worker_result_invalid);
}

bool opengl_failed(const WorkerResult& end) {
    return end.status == static_cast<int>(cli::ExitStatus::backend);
}

}  // namespace vvr::workers
