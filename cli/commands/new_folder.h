#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "cli/plan/observer.h"
#include "core/base/lock_file.h"

namespace vvr::commands {

/// A folder that appears with all its files or not at all. The files are written to a hidden folder beside it, which
/// the destructor removes unless `publish` was called. All runs that make the same folder use the same hidden one, and
/// a lock lets them do so one at a time: so the next run removes what a killed one left.
class NewFolder {
  public:
    /// \param path must not exist, or be an empty folder, whose group and permissions the new one takes over
    /// \param setting that names the folder, for messages
    /// \throws Error io
    NewFolder(std::filesystem::path path, std::string_view setting);
    ~NewFolder();
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;

    /// Where the files are written.
    const std::filesystem::path& hidden() const { return hidden_; }

    /// \throws Error io
    void publish();

  private:
    std::filesystem::path path_;
    std::optional<LockFile> lock_;
    std::filesystem::path hidden_;
};

/// \param setting that names the folder, for messages
/// \throws Error io if anything but an empty folder is at `path`
void check_is_free(const std::filesystem::path& path, std::string_view setting);

/// An observer for code that writes several files while the caller holds back signals.
class HeldObserver final : public app::Observer {
  public:
    explicit HeldObserver(app::Observer& observer) : observer_(observer), held_(observer.guard()) {}

    void frames(std::int64_t done, std::int64_t expected) override { observer_.frames(done, expected); }
    void drawing(std::int64_t done, std::int64_t parts) override { observer_.drawing(done, parts); }
    void debug(const std::string& text) override { observer_.debug(text); }
    void info(const std::string& text) override { observer_.info(text); }
    void warn(const std::string& text, const RelatedSettings& about = {}) override { observer_.warn(text, about); }

  private:
    app::Observer& observer_;
    std::unique_lock<std::mutex> held_;
};

}  // namespace vvr::commands
