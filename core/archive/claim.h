#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace vvr::archive {

/// The right to write the files of one name in a folder, as long as this object lives. It is a lock (`flock`) on a
/// hidden file: the kernel releases it however the program ends, and it holds between machines if the file system's
/// locks do.
class Claim {
  public:
    /// Nothing when another program has it.
    /// \throws Error io
    static std::optional<Claim> try_take(const std::filesystem::path& folder, const std::string& name);

    /// Waits until nobody else has it. A signal ends the wait, as it ends the program.
    /// \throws Error io, also when another program has it for longer than `patience`
    static Claim wait_for(const std::filesystem::path& folder, const std::string& name,
                          std::chrono::milliseconds patience = std::chrono::minutes(5));

    /// Takes over the claim of a killed program, and says the name that it is for. Nothing when another program has
    /// it, or when the file is not a claim: not a regular file, or without the plain name from which its own name is
    /// made. Such a file is left alone.
    static std::optional<std::pair<Claim, std::string>> take_over(const std::filesystem::path& file);

    /// Whether `file` has the name of a claim's hidden file.
    static bool is_claim(const std::filesystem::path& file);

    Claim(Claim&& other) noexcept;
    Claim& operator=(Claim&&) = delete;
    Claim(const Claim&) = delete;
    Claim& operator=(const Claim&) = delete;
    ~Claim();

    /// Whether the program that had it before was killed. Then there may be files that it was writing.
    bool was_left_behind() const { return left_behind_; }

    /// A child process that inherits it holds the claim as long as it lives.
    int descriptor() const { return file_; }

  private:
    Claim(std::filesystem::path path, int file, bool left_behind);

    static std::optional<Claim> take(const std::filesystem::path& path, const std::string& name);

    std::filesystem::path path_;
    int file_;
    bool left_behind_;
};

}  // namespace vvr::archive
