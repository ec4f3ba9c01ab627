#pragma once

#include <cstdint>
#include <mutex>
#include <string>

#include "core/base/error.h"

namespace vvr::app {

/// Hears how a run goes. Calls may come from any thread.
class Observer {
  public:
    virtual ~Observer() = default;

    /// So far `done` frames have been read, of `expected`; 0 = unknown.
    virtual void frames(std::int64_t /*done*/, std::int64_t /*expected*/) {}

    virtual void debug(const std::string& /*text*/) {}
    virtual void info(const std::string& /*text*/) {}

    /// \param about the settings that the advice in the text is about
    virtual void warn(const std::string& /*text*/, const RelatedSettings& /*about*/ = {}) {}

    /// While the lock is held a file is being written, and the process should not end.
    [[nodiscard]] virtual std::unique_lock<std::mutex> guard() { return {}; }
};

}  // namespace vvr::app
