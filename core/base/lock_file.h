#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace vvr {

/// The exclusive right to write the files of one name in a folder, for the life of this object. It is a lock (`flock`)
/// on a hidden file: the kernel releases it however the program ends. It holds between machines if the file system's
/// locks do.
class LockFile {
  public:
    /// Takes the lock; nothing if another program holds it.
    /// \throws Error io
    static std::optional<LockFile> try_take(const std::filesystem::path& folder, const std::string& name);

    /// Waits for the lock. A signal ends the program, and so the wait.
    /// \throws Error io, also if another program holds it for longer than `patience`
    static LockFile wait_for(const std::filesystem::path& folder, const std::string& name,
                             std::chrono::milliseconds patience = std::chrono::minutes(5));

    /// Takes over the lock of a killed program.
    /// \returns the lock and the name that it protects. Nothing if another program holds it, or if vvr did not make the
    ///        file: it is not a regular file, or its content does not give its name. Such a file stays unchanged.
    static std::optional<std::pair<LockFile, std::string>> take_over(const std::filesystem::path& file);

    /// Whether `file` has the name of a lock's hidden file.
    static bool is_lock_file(const std::filesystem::path& file);

    /// Whether `file` is the hidden file of the lock of `name` in its folder.
    static bool is_lock_of(const std::string& name, const std::filesystem::path& file);

    LockFile(LockFile&& other) noexcept;
    LockFile& operator=(LockFile&&) = delete;
    LockFile(const LockFile&) = delete;
    LockFile& operator=(const LockFile&) = delete;
    ~LockFile();

    /// Whether its previous owner was killed. Then there may be unfinished files.
    bool is_stale() const { return stale_; }

    /// The lock's file descriptor. A child process that inherits it holds the lock for its own life.
    int descriptor() const { return file_; }

  private:
    LockFile(std::filesystem::path path, int file, bool left_behind);

    static std::optional<LockFile> take(const std::filesystem::path& path, const std::string& name);

    std::filesystem::path path_;
    int file_;
    bool stale_;
};

}  // namespace vvr
