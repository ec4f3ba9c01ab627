#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace vvr {

/// The right to write the files of one name in a folder, until this is gone. It is a lock (`flock`) on a hidden file,
/// so the kernel lets go of it whatever ends the program, and it holds between machines where the file system's locks
/// do.
class Claim {
  public:
    /// Nothing when another program has it.
    /// \throws Error io
    static std::optional<Claim> try_take(const std::filesystem::path& folder, const std::string& name);

    /// Waits until nobody else has it.
    /// \throws Error io
    static Claim wait_for(const std::filesystem::path& folder, const std::string& name);

    /// What a claim that was left behind is about, taken over. Nothing where somebody has it, or where the file is
    /// none: no regular file, or one that does not hold the plain name of which its own name is made. Such a file
    /// stays.
    static std::optional<std::pair<Claim, std::string>> take_over(const std::filesystem::path& file);

    /// Whether `file` is the hidden file of a claim, by its name.
    static bool is_claim(const std::filesystem::path& file);

    Claim(Claim&& other) noexcept;
    Claim& operator=(Claim&&) = delete;
    ~Claim();

    /// Whether the last one who had it was killed. Then what it was writing may lie about.
    bool was_left_behind() const { return left_behind_; }

    /// A child that inherits it keeps the claim from others as long as it lives.
    int descriptor() const { return file_; }

  private:
    Claim(std::filesystem::path path, int file, bool left_behind);

    static std::optional<Claim> take(const std::filesystem::path& path, const std::string& name, bool wait);

    std::filesystem::path path_;
    int file_;
    bool left_behind_;
};

}  // namespace vvr
