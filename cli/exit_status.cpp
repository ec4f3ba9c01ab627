#include "cli/exit_status.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <system_error>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>

#include "cli/log.h"
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
    Row{ErrorKind::differs, ExitStatus::differs},     Row{ErrorKind::bug, ExitStatus::bug},
};

}  // namespace

std::span<const StatusHelp> exit_statuses() {
    static constexpr std::array all{
        StatusHelp{0, "success, also if nothing was found: a clip without events, an archive without clips"},
        StatusHelp{1, "an error in the command line or the config file"},
        StatusHelp{2, "a file can't be read or written"},
        StatusHelp{3, "the input is not usable video"},
        StatusHelp{
            4,
            "no OpenGL backend, or OpenGL failed; no such hardware for `--hwaccel`; `archive --sandbox required`: "
            "the kernel has no such sandbox"},
        StatusHelp{5, "out of memory, or over a given limit"},
        StatusHelp{
            6,
            "`archive`: some clips failed, some files of a day could not be read, or some events could not be kept; "
            "the "
            "others are done. `golden`: a picture "
            "could not be drawn or compared. A recording: some files were skipped completely, because others show the "
            "same time"},
        StatusHelp{7, "a picture differs from its golden image, or there is no golden image to compare with"},
        StatusHelp{70, "an internal error: a bug in vvr"},
        StatusHelp{129, "ended by SIGHUP, as a shell reports it; `watch` finishes its picture and exits with 0"},
        StatusHelp{130, "ended by SIGINT, in the same way"},
        StatusHelp{143, "ended by SIGTERM, in the same way"},
    };
    return all;
}

ExitStatus exit_status(ErrorKind kind) {
    const auto row = std::ranges::find(table, kind, &Row::kind);
    return row == table.end() ? ExitStatus::bug : row->status;
}

std::optional<ErrorCode> code_of_status(int status) {
    const auto row = std::ranges::find(table, static_cast<ExitStatus>(status), &Row::status);
    return row == table.end() ? std::nullopt : std::optional(general_code(row->kind));
}

namespace {

/// Whether the text begins with the setting's name, such as "threshold: 300 is not between 0 and 255".
bool begins_with(const std::string& text, const std::string& name) {
    if (!text.starts_with(name) || text.size() == name.size()) return false;
    return text[name.size()] == ':' || text[name.size()] == ' ';
}

}  // namespace

std::string with_flags(const std::string& text, const RelatedSettings& about) {
    std::string flagged = text;
    std::string others;
    for (const std::string& name : about.names()) {
        if (begins_with(text, name)) {
            flagged = fmt::format("--{}", text);
        } else {
            others += fmt::format("{}--{}", others.empty() ? "" : ", ", name);
        }
    }
    return others.empty() ? flagged : fmt::format("{} ({})", flagged, others);
}

namespace {

constexpr std::string_view out_of_memory =
    "out of memory; try a smaller --field-size, --size or --window (`vvr info` estimates the memory needed)";

/// The handler for std::terminate. Exceptions thrown while libraries are loaded or unloaded can't be caught.
[[noreturn]] void end_program() {
    try {
        if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
    } catch (const std::exception& error) {
        if (is_out_of_memory(error)) {
            for (const std::string_view text : {"vvr: ", out_of_memory.data(), " [out-of-memory]\n"}) {
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

namespace {

Outcome outcome_of(const std::function<ExitStatus()>& action) {
    const auto outcome = [](ErrorCode code, std::string text) {
        return Outcome{exit_status(row_of(code).kind), code, std::move(text)};
    };
    try {
        return {action()};
    } catch (const Error& error) {
        return outcome(error.code(), with_flags(error.what(), error.about()));
    } catch (const std::exception& error) {
        if (is_out_of_memory(error)) return outcome(ErrorCode::out_of_memory, std::string(out_of_memory));
        if (const auto* const system = dynamic_cast<const std::system_error*>(&error)) {
            return outcome(code_of_system_error(system->code().value()), error.what());
        }
        return outcome(ErrorCode::bug,
                       fmt::format("this is a bug in vvr, please report it with the command line: {}", error.what()));
    }
}

}  // namespace

Outcome report_errors(spdlog::logger& log, const std::function<ExitStatus()>& action) {
    Outcome outcome = outcome_of(action);
    if (outcome.code) log_error(log, *outcome.code, outcome.text);
    return outcome;
}

}  // namespace vvr::cli
