#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

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
