#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <climits>

namespace vvr {

/// ASCII letters in lower case.
inline std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

/// The extension with its dot, in lower case: `.png` of `out.PNG`. Empty if there is none.
inline std::string extension_of(const std::filesystem::path& path) {
    return lower_case(path.extension().string());
}

/// Maximum length of a file's name, in bytes.
inline constexpr std::size_t longest_name = NAME_MAX;

/// Whether a name is safe to use in a folder: it can't lead to another folder and is a valid file name. Check every
/// name read from a file, because others may have written the file.
constexpr bool is_plain_name(std::string_view name) {
    return !name.empty() && name.size() <= longest_name && name != "." && name != ".." &&
           name.find_first_of(std::string_view("/\0", 2)) == std::string_view::npos;
}

/// Whether all components of a relative path are plain names, so that it stays below its folder.
constexpr bool is_plain_path(std::string_view path) {
    for (auto slash = path.find('/'); slash != std::string_view::npos; slash = path.find('/')) {
        if (!is_plain_name(path.substr(0, slash))) return false;
        path.remove_prefix(slash + 1);
    }
    return is_plain_name(path);
}

/// Owns the descriptor of an open file; negative = none.
class Descriptor {
  public:
    explicit Descriptor(int file = -1) : file_(file) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept : file_(other.release()) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(file_, other.file_);
        return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int get() const { return file_; }
    int release() { return std::exchange(file_, -1); }

  private:
    int file_;
};

/// Opens a regular file. Refuses symbolic links, FIFOs and devices, which anyone may have placed there, without
/// blocking.
/// \param flags of open(2), with or without `O_CREAT`
/// \returns a descriptor, or -1 with `errno`
int open_no_follow(const std::filesystem::path& path, int flags);

/// Locks an open file exclusively (`flock`) until its last descriptor is closed.
/// \returns 0, or the error: `EWOULDBLOCK` if another process holds the lock
int lock_file(int file, bool wait);

/// Whether `path` still names the open file: the lock's previous holder may have removed or renamed it.
/// \param follow also through a symbolic link
bool is_same_file(int file, const std::filesystem::path& path, bool follow = false);

/// Limits on the size of files to read, in bytes.
namespace most_bytes {
inline constexpr std::uintmax_t text = std::uintmax_t{16} << 20U;  ///< written by people: settings, points, addresses
inline constexpr std::uintmax_t data = std::uintmax_t{1} << 30U;   ///< written by programs: flow, lists, reports
}  // namespace most_bytes

/// Refuses devices and pipes, which may be endless, but accepts a shell's process substitution (`<(...)`). Missing
/// files pass.
/// \param most maximum size in bytes
/// \throws Error io for anything but a file, limit for a file that is too long
void check_is_file(const std::string& path, std::uintmax_t most = UINTMAX_MAX);

/// Reads a whole file.
/// \param most maximum size in bytes; a file system may report more than memory can hold
/// \throws Error io with the system's reason if it can't be read, limit if it is longer
std::string read_file(const std::string& path, std::uintmax_t most = most_bytes::data);

/// Modification time of a file, seconds since 1970 (UTC). Empty if it is not a regular file.
std::optional<double> modified_at(const std::string& path);

/// Whether an output's name means standard output.
inline bool is_standard_output(const std::filesystem::path& path) {
    return path == "-";
}

/// Writes data to standard output. A reader that closes the pipe early, such as `head`, is no error.
/// \throws Error io
void write_standard_output(std::span<const std::byte> bytes);

}  // namespace vvr
