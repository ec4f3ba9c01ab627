#include "cli/log.h"

#include <string_view>

#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_sinks.h>

namespace vvr {

namespace {

/// Marks warnings; other lines speak for themselves.
class WarningFlag : public spdlog::custom_flag_formatter {
  public:
    void format(const spdlog::details::log_msg& message, const std::tm&, spdlog::memory_buf_t& out) override {
        constexpr std::string_view mark = "warning: ";
        if (message.level == spdlog::level::warn) out.append(mark.data(), mark.data() + mark.size());
    }
    std::unique_ptr<custom_flag_formatter> clone() const override { return std::make_unique<WarningFlag>(); }
};

}  // namespace

std::shared_ptr<spdlog::logger> make_log() {
    auto log = std::make_shared<spdlog::logger>("vvr", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    auto formatter = std::make_unique<spdlog::pattern_formatter>();
    formatter->add_flag<WarningFlag>('*').set_pattern("vvr: %*%v");
    log->set_formatter(std::move(formatter));
    return log;
}

void set_talk(spdlog::logger& log, Talk talk) {
    switch (talk) {
        case Talk::quiet:
            log.set_level(spdlog::level::err);
            break;
        case Talk::normal:
            log.set_level(spdlog::level::info);
            break;
        case Talk::verbose:
            log.set_level(spdlog::level::debug);
            break;
    }
}

}  // namespace vvr
