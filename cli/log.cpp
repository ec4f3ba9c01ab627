#include "cli/log.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/stdout_sinks.h>

#include "cli/appended_file.h"
#include "core/base/json_text.h"
#include "core/base/text.h"

namespace vvr::cli {

namespace {

constexpr std::size_t on_stderr = 0;  // index in sinks()

// Of both formats, and of the lines on stderr, which a shell may have put into the same file.
constexpr std::array<std::string_view, 3> first_log_line{
    "0000-00-00T00:00:00Z vvr: ", R"({"time":"0000-00-00T00:00:00)", "vvr: "};
constexpr AppendedKind log_kind{"the log", false, first_log_line};

/// Where a line keeps the name of its error's code: spdlog's source location, which we don't use otherwise.
/// Its file's name is a JSON object: further members of a JSON line.
spdlog::source_loc source_of(ErrorCode code, const char* members = "{}") {
    return {members, 1, row_of(code).name};
}

/// Appends lines to a file.
class LogFile final : public spdlog::sinks::base_sink<std::mutex> {
  public:
    /// \param screen learns of the first line that is lost
    /// \throws Error io
    LogFile(const std::string& path, spdlog::sink_ptr screen)
        : path_(path), file_(path, log_kind), screen_(std::move(screen)) {}

    bool is_whole() const { return is_whole_; }

  protected:
    // A failed write loses the line; a log must not make a picture fail.
    void sink_it_(const spdlog::details::log_msg& message) override {
        spdlog::memory_buf_t line;
        formatter_->format(message, line);
        const int error = file_.append({line.data(), line.size()});
        if (error == 0 || !is_whole_.exchange(false)) return;
        const std::string text =
            fmt::format("cannot write the log '{}': {}; lines of it are lost", path_, text_of_system_error(error));
        screen_->log({source_of(code_of_system_error(error)), "vvr", spdlog::level::err, text});
    }
    void flush_() override {}

  private:
    std::string path_;
    AppendedFile file_;
    spdlog::sink_ptr screen_;
    std::atomic<bool> is_whole_ = true;
};

/// Marks warnings. Other lines have no mark.
class WarningFlag : public spdlog::custom_flag_formatter {
  public:
    void format(const spdlog::details::log_msg& message, const std::tm&, spdlog::memory_buf_t& out) override {
        constexpr std::string_view mark = "warning: ";
        if (message.level == spdlog::level::warn) out.append(mark.data(), mark.data() + mark.size());
    }
    std::unique_ptr<custom_flag_formatter> clone() const override { return std::make_unique<WarningFlag>(); }
};

std::string payload_of(const spdlog::details::log_msg& message) {
    return shown_text(redact_secrets({message.payload.data(), message.payload.size()}));
}

/// The name of an error's code; null for other lines.
const char* code_of(const spdlog::details::log_msg& message) {
    return message.source.funcname;
}

/// The message, made safe for terminals and logs: names in it are untrusted. The code's name follows.
class SafeText : public spdlog::custom_flag_formatter {
  public:
    void format(const spdlog::details::log_msg& message, const std::tm&, spdlog::memory_buf_t& out) override {
        std::string text = payload_of(message);
        if (const char* const code = code_of(message)) text += fmt::format(" [{}]", code);
        out.append(text.data(), text.data() + text.size());
    }
    std::unique_ptr<custom_flag_formatter> clone() const override { return std::make_unique<SafeText>(); }
};

/// A JSON object with time (UTC), level and message.
class JsonLines : public spdlog::formatter {
  public:
    void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& out) override {
        const auto time = std::chrono::floor<std::chrono::milliseconds>(message.time);
        const auto level = spdlog::level::to_string_view(message.level);
        Json line{
            {"time", fmt::format("{:%Y-%m-%dT%H:%M:%S}Z", fmt::gmtime(std::chrono::system_clock::to_time_t(time)))},
            {"level", std::string(level.data(), level.size())},
            {"message", payload_of(message)}};
        if (const char* const code = code_of(message)) {
            line["code"] = code;
            line.update(parse_json(message.source.filename));
        }
        const std::string text = json_text(line) + "\n";
        out.append(text.data(), text.data() + text.size());
    }
    std::unique_ptr<formatter> clone() const override { return std::make_unique<JsonLines>(); }
};

std::unique_ptr<spdlog::formatter> text_lines(bool timed) {
    auto lines = std::make_unique<spdlog::pattern_formatter>(spdlog::pattern_time_type::utc);
    lines->add_flag<WarningFlag>('*').add_flag<SafeText>('?');
    lines->set_pattern(timed ? "%Y-%m-%dT%H:%M:%SZ vvr: %*%?" : "vvr: %*%?");
    return lines;
}

std::unique_ptr<spdlog::formatter> json_lines(bool) {
    return std::make_unique<JsonLines>();
}

constexpr std::array formats{
    LogFormat{"text", "lines for people", text_lines},
    LogFormat{"json", "a JSON object per line, with its time", json_lines},
};

class KeptWarnings final : public spdlog::sinks::base_sink<std::mutex> {
  public:
    explicit KeptWarnings(std::size_t most) : most_(most) {}

    std::vector<std::string> texts() {
        const std::lock_guard lock(mutex_);
        return texts_;
    }

  protected:
    void sink_it_(const spdlog::details::log_msg& message) override {
        if (message.level == spdlog::level::warn && texts_.size() < most_) texts_.push_back(payload_of(message));
    }
    void flush_() override {}

  private:
    std::size_t most_;
    std::vector<std::string> texts_;
};

}  // namespace

std::shared_ptr<spdlog::logger> make_log() {
    auto log = std::make_shared<spdlog::logger>("vvr", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    log->set_level(spdlog::level::debug);
    set_format(*log, formats.front());
    set_verbosity(*log, Verbosity::normal);
    return log;
}

void log_error(spdlog::logger& log, ErrorCode code, std::string_view text, const std::string& members) {
    log.log(source_of(code, members.c_str()), spdlog::level::err, "{}", text);
}

void set_verbosity(spdlog::logger& log, Verbosity verbosity) {
    constexpr std::array levels{spdlog::level::err, spdlog::level::info, spdlog::level::debug};
    log.sinks()[on_stderr]->set_level(levels[static_cast<std::size_t>(verbosity)]);
}

std::span<const LogFormat> log_formats() {
    return formats;
}

const LogFormat& row_of(Name<LogFormat> name) {
    return choose("log-format", name.text, formats);
}

void set_format(spdlog::logger& log, const LogFormat& format) {
    log.sinks()[on_stderr]->set_formatter(format.make(false));
}

std::function<bool()> add_file(spdlog::logger& log, const std::string& path, const LogFormat& format) {
    auto file = std::make_shared<LogFile>(path, log.sinks()[on_stderr]);
    file->set_formatter(format.make(true));
    file->set_level(std::min(spdlog::level::info, log.sinks()[on_stderr]->level()));
    log.sinks().push_back(file);
    return [file] { return file->is_whole(); };
}

std::function<std::vector<std::string>()> keep_warnings(spdlog::logger& log, std::size_t most) {
    auto kept = std::make_shared<KeptWarnings>(most);
    log.sinks().push_back(kept);
    return [kept] { return kept->texts(); };
}

}  // namespace vvr::cli
