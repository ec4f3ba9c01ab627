#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "cli/app/observer.h"
#include "cli/environment.h"
#include "cli/progress.h"

namespace vvr::cli {

/// Shows a run to people: a bar, and lines in the log. Signals wait for files that are being written.
class Console final : public app::Observer {
  public:
    /// \param bar whether a bar shows how far the run is; only a terminal gets one, and only where others are not quiet
    Console(const Environment& environment, bool bar = true);

    void frames(std::int64_t done, std::int64_t expected) override;
    void debug(const std::string& text) override;
    void info(const std::string& text) override;
    void warn(const std::string& text, const RelatedSettings& about = {}) override;
    std::unique_lock<std::mutex> guard() override;

  private:
    void clear();

    const Environment& environment_;
    bool bar_;
    std::mutex mutex_;
    std::optional<Progress> progress_;
};

}  // namespace vvr::cli
