#pragma once

#include <cstdint>
#include <mutex>
#include <string>

#include "core/base/error.h"

namespace vvr::app {

/// Receives the progress of a run. Calls may come from any thread.
class Observer {
  public:
    virtual ~Observer() = default;

    /// `done` frames of `expected` have been read; 0 = unknown.
    virtual void frames(std::int64_t /*done*/, std::int64_t /*expected*/) {}

    /// All frames have been read, and `done` of `parts` equal parts of a picture are drawn.
    virtual void drawing(std::int64_t /*done*/, std::int64_t /*parts*/) {}

    virtual void debug(const std::string& /*text*/) {}
    virtual void info(const std::string& /*text*/) {}

    /// \param about the settings that the text's advice mentions
    virtual void warn(const std::string& /*text*/, const RelatedSettings& /*about*/ = {}) {}

    /// Lock it while writing a file, so that no signal ends the process.
    [[nodiscard]] virtual std::unique_lock<std::mutex> guard() { return {}; }
};

}  // namespace vvr::app
