#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

// Limits of what an archive's files may contain. Others may have written them, and one absurd number must not stop the
// rest.
namespace vvr::archive {

inline constexpr std::int64_t last_time = 7'258'118'400;          ///< 2200-01-01, in seconds since 1970
inline constexpr double longest_recording = 10.0 * 366 * 86'400;  ///< seconds; no clip or day lasts longer
inline constexpr std::size_t largest_sidecar = std::size_t{32} << 20;
inline constexpr std::size_t largest_report = 100'000'000;

/// Whether a time (seconds since 1970) is plausible for a recording: 1970 to 2199.
constexpr bool can_be_time(std::int64_t seconds) {
    return seconds >= 0 && seconds < last_time;
}

}  // namespace vvr::archive

// A clip is identified by its path below the archive's folder, as bytes: file systems have no encoding.
namespace vvr::archive {

/// The path as valid UTF-8: invalid bytes, control characters and `%` become `%FF`. `path_of_text` restores the bytes.
std::string text_of_path(std::string_view path);

std::string path_of_text(std::string_view text);

/// The kinds of files that an archive writes for a clip, all named after it: `cam1/x.avi` gives `cam1/x.avi.png`.
enum class OutputKind { picture, page, thumbnail, report, still, stills };

struct OutputRow {
    OutputKind kind;
    std::string_view name;
    std::string_view extension;
};

inline constexpr std::array output_rows{
    OutputRow{OutputKind::picture, "picture", ".png"},     OutputRow{OutputKind::page, "page", ".html"},
    OutputRow{OutputKind::thumbnail, "thumbnail", ".jpg"}, OutputRow{OutputKind::report, "report", ".report.json"},
    OutputRow{OutputKind::still, "still", ".still.jpg"},   OutputRow{OutputKind::stills, "stills", ".stills.jpg"},
};

inline constexpr std::string_view sidecar_extension = ".json";
inline constexpr std::string_view index_name = "index.html";

std::filesystem::path output_path(const std::filesystem::path& out, const std::string& clip, OutputKind kind);
std::filesystem::path sidecar_path(const std::filesystem::path& out, const std::string& clip);

}  // namespace vvr::archive

// The files of an archive in its folder of pictures. Others may write there too: anything else in the place of such a
// file is reported and left alone.
namespace vvr::archive {

/// What is at a path instead of a file, such as "a link" or "a pipe"; nothing for a file, or where nothing is.
std::optional<std::string_view> irregular_file_at(const std::filesystem::path& path);

/// Whether a regular file is at a path: no link to one.
bool is_own_file(const std::filesystem::path& path);

/// Removes a file. Anything but a regular file stays.
/// \returns whether there was one
/// \throws Error io
bool remove_own(const std::filesystem::path& file);

/// The same without an exception.
bool remove_own(const std::filesystem::path& file, std::error_code& error);

/// Checks that a file may be written here.
/// \throws Error io if something other than a file is there
void check_own_place(const std::filesystem::path& file);

/// Checks the way to a folder.
/// \param folder `out` or below it
/// \throws Error io if anything from `out` to `folder` is no folder: a link leads elsewhere
void check_own_folder(const std::filesystem::path& out, const std::filesystem::path& folder);

/// The result of `read_own`.
struct OwnText {
    std::optional<std::string> text;  ///< nothing if there is no file, or it begins differently
    std::string problem;              ///< why an existing file can't be read; empty = no problem
};

/// Reads a file that begins with `beginning`. Follows no link, never blocks, and stops reading a file that begins
/// differently or is larger than `most` bytes.
OwnText read_own(const std::filesystem::path& file, std::string_view beginning, std::size_t most);

}  // namespace vvr::archive
