#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

// What can be in a file of an archive. Others may have written it, and one absurd number must not hold up the rest.
namespace vvr::archive {

inline constexpr std::int64_t last_time = 7'258'118'400;          ///< 2200-01-01, in seconds since 1970
inline constexpr double longest_recording = 10.0 * 366 * 86'400;  ///< seconds: no clip, and no day, is that long
inline constexpr std::size_t largest_sidecar = std::size_t{32} << 20;
inline constexpr std::size_t largest_report = 100'000'000;

/// Whether a time in seconds since 1970 can be that of a recording: of 1970 to 2199.
constexpr bool can_be_time(std::int64_t seconds) {
    return seconds >= 0 && seconds < last_time;
}

}  // namespace vvr::archive

// A clip is identified by its path below the archive's folder, in bytes: file systems have no encoding.
namespace vvr::archive {

/// The path as valid UTF-8, from which `path_of_text` makes the same bytes again: bytes that are not UTF-8, control
/// characters and `%` become `%FF`.
std::string text_of_path(std::string_view path);

std::string path_of_text(std::string_view text);

/// The files that an archive writes for a clip, all named after it: `cam1/x.avi` gives `cam1/x.avi.png`.
enum class OutputKind { picture, page, thumbnail, report, still };

struct OutputRow {
    OutputKind kind;
    std::string_view name;
    std::string_view ending;
};

inline constexpr std::array output_rows{
    OutputRow{OutputKind::picture, "picture", ".png"},     OutputRow{OutputKind::page, "page", ".html"},
    OutputRow{OutputKind::thumbnail, "thumbnail", ".jpg"}, OutputRow{OutputKind::report, "report", ".report.json"},
    OutputRow{OutputKind::still, "still", ".still.jpg"},
};

inline constexpr std::string_view sidecar_extension = ".json";
inline constexpr std::string_view index_name = "index.html";

std::filesystem::path output_path(const std::filesystem::path& out, const std::string& clip, OutputKind kind);
std::filesystem::path sidecar_path(const std::filesystem::path& out, const std::string& clip);

}  // namespace vvr::archive

// The files that an archive has in its folder of pictures. Others may write there too: what stands in the place of such
// a file and is none is named, and left alone.
namespace vvr::archive {

/// What stands at a path where a file should: "a link", "a pipe"; nothing for a file, and where nothing is.
std::optional<std::string_view> irregular_file_at(const std::filesystem::path& path);

/// \throws Error io when something else than a file is where one is to be written
void check_own_place(const std::filesystem::path& file);

/// \param folder `out`, or below it
/// \throws Error io when something else than a folder is on the way from `out` to `folder`: a link leads elsewhere
void check_own_folder(const std::filesystem::path& out, const std::filesystem::path& folder);

/// What is read of such a file.
struct OwnText {
    std::optional<std::string> text;  ///< nothing when it is not there, or does not begin as asked
    std::string problem;              ///< why it can't be read although it is there; empty = none
};

/// All of a file that begins with `beginning`. No link is followed, nothing is waited for, and of what begins otherwise
/// or is too large no more is read.
OwnText read_own(const std::filesystem::path& file, std::string_view beginning, std::size_t most);

}  // namespace vvr::archive
