#include "cli/event_file.h"

#include <array>
#include <cerrno>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cli/log.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"

namespace vvr::cli {

namespace {

namespace fs = std::filesystem;

std::string name_of(const fs::path& path) {
    return is_standard_output(path) ? "standard output" : fmt::format("'{}'", path.string());
}

constexpr std::array<std::string_view, 1> first_event{R"({"camera":)"};
constexpr AppendedKind kind{"events to", true, first_event};

}  // namespace

EventFile::EventFile(fs::path path, spdlog::logger& log) : path_(std::move(path)), log_(log) {
    if (!path_.empty()) file_.emplace(path_, kind);
}

void EventFile::add(const tracking::EventLine& line) {
    if (!file_) return;
    const int error = file_->append(tracking::format_event_line(line));
    if (error == 0) return;
    error_ = error;
    if (++lost_ > 1) return;
    log_.warn("cannot write an event to {}: {}; it is lost, and pictures go on", name_of(path_),
              error == ETIMEDOUT ? "its reader takes nothing" : text_of_system_error(error));
}

bool EventFile::finish() {
    if (lost_ == 0) return true;
    log_error(log_, code_of_system_error(error_),
              fmt::format("{} could not be written to {}; the pictures are complete",
                          counted(static_cast<std::int64_t>(lost_), "event"), name_of(path_)));
    return false;
}

}  // namespace vvr::cli
