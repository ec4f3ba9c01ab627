#pragma once

#include <functional>
#include <optional>
#include <string>

namespace vvr::detector {

/// What a child process may use before it is ended.
struct TrialLimits {
    int megabytes = 4096;     ///< in addition to what the process has already
    int seconds = 60;         ///< of processor time
    int clock_seconds = 600;  ///< a busy machine gives a process a small part of its time
};

/// Runs an action in a child process, so that a crash ends only the child. The child has one thread, and its stderr
/// goes nowhere.
/// \returns why the action failed: the text of its exception, or how the child ended. Nothing if it succeeded.
/// \throws Error limit if no child can be started
std::optional<std::string> failure_in_child(const std::function<void()>& action, const TrialLimits& limits = {});

}  // namespace vvr::detector
