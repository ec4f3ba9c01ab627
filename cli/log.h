#pragma once

#include <memory>

#include <spdlog/logger.h>

namespace vvr {

/// A logger to stderr, each line `vvr: text`, or `vvr: warning: text`.
std::shared_ptr<spdlog::logger> make_log();

/// How much a logger says.
enum class Talk { quiet, normal, verbose };

void set_talk(spdlog::logger& log, Talk talk);

}  // namespace vvr
