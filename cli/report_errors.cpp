#include "cli/report_errors.h"

#include <exception>
#include <system_error>

#include <fmt/format.h>

#include "core/out_of_memory.h"

namespace vvr {

std::string with_flags(const std::string& text, const About& about) {
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

ExitStatus out_of_memory(spdlog::logger& log) {
    log.error("out of memory; try a smaller --field-size, --size or --window (`vvr info` estimates the need)");
    return ExitStatus::limit;
}

}  // namespace

ExitStatus report_errors(spdlog::logger& log, const std::function<ExitStatus()>& action) {
    try {
        return action();
    } catch (const Error& error) {
        log.error("{}", with_flags(error.what(), error.about()));
        return exit_status(error.kind());
    } catch (const std::exception& error) {
        if (is_out_of_memory(error)) return out_of_memory(log);
        if (dynamic_cast<const std::system_error*>(&error) != nullptr) {
            log.error("{}", error.what());
            return ExitStatus::io;
        }
        log.error("this is a bug in vvr, please report it with the command line: {}", error.what());
        return ExitStatus::bug;
    }
}

}  // namespace vvr
