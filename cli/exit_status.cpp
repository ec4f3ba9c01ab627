#include "cli/exit_status.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include <fmt/format.h>

#include "core/base/memory.h"

namespace vvr::cli {

namespace {

struct Row {
    ErrorKind kind;
    ExitStatus status;
};

constexpr std::array table{
    Row{ErrorKind::usage, ExitStatus::usage},         Row{ErrorKind::io, ExitStatus::io},
    Row{ErrorKind::not_video, ExitStatus::not_video}, Row{ErrorKind::backend, ExitStatus::backend},
    Row{ErrorKind::limit, ExitStatus::limit},         Row{ErrorKind::partial, ExitStatus::partial},
    Row{ErrorKind::differs, ExitStatus::differs},
};

}  // namespace

ExitStatus exit_status(ErrorKind kind) {
    const auto row = std::ranges::find(table, kind, &Row::kind);
    return row == table.end() ? ExitStatus::bug : row->status;
}

std::string with_flags(const std::string& text, const RelatedSettings& about) {
    std::string flagged = text;
    std::string others;
    for (const std::string& name : about.names()) {
        if (text.starts_with(name)) {
            flagged = fmt::format("--{}", text);
        } else {
            others += fmt::format("{}--{}", others.empty() ? "" : ", ", name);
        }
    }
    return others.empty() ? flagged : fmt::format("{} ({})", flagged, others);
}

namespace {

constexpr std::string_view out_of_memory =
    "out of memory; try a smaller --field-size, --size or --window (`vvr info` estimates the need)";

/// What std::terminate does. Where libraries are loaded or clean up, nothing that they throw can be caught.
[[noreturn]] void end_program() {
    try {
        if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
    } catch (const std::exception& error) {
        if (is_out_of_memory(error)) {
            for (const std::string_view text : {std::string_view("vvr: "), out_of_memory, std::string_view("\n")}) {
                [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
            }
            ::_exit(static_cast<int>(ExitStatus::limit));
        }
    } catch (...) {
    }
    __gnu_cxx::__verbose_terminate_handler();
    std::abort();
}

}  // namespace

void install_terminate_handler() {
    std::set_terminate(end_program);
}

ExitStatus report_errors(spdlog::logger& log, const std::function<ExitStatus()>& action) {
    try {
        return action();
    } catch (const Error& error) {
        log.error("{}", with_flags(error.what(), error.about()));
        return exit_status(error.kind());
    } catch (const std::exception& error) {
        if (is_out_of_memory(error)) {
            log.error("{}", out_of_memory);
            return ExitStatus::limit;
        }
        if (dynamic_cast<const std::system_error*>(&error) != nullptr) {
            log.error("{}", error.what());
            return ExitStatus::io;
        }
        log.error("this is a bug in vvr, please report it with the command line: {}", error.what());
        return ExitStatus::bug;
    }
}

}  // namespace vvr::cli
