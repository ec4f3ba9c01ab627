#include "core/video/camera_folders.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace vvr::video {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// 2026, 2026-11, 20261121, 2026_11_21: a year, then only numbers.
bool is_date(std::string_view folder) {
    const bool year = folder.size() >= 4 && (folder.starts_with("19") || folder.starts_with("20")) &&
                      std::ranges::all_of(folder.substr(0, 4), is_digit);
    if (folder.size() == 14 && folder[4] == 'Y' && folder.back() == 'H') return year;  // 2026Y11M21D20H
    if (folder.ends_with("AM") || folder.ends_with("PM")) folder.remove_suffix(2);
    if (!year || folder.size() == 5 || folder.size() > 10) return false;
    return std::ranges::all_of(folder.substr(4),
                               [](char c) { return is_digit(c) || c == '-' || c == '_' || c == '.'; });
}

/// What stands in folders below a date: month, day, hour ("20", "20h").
bool is_part_of_date(std::string_view folder) {
    if (is_date(folder)) return true;
    if (folder.size() == 3 && folder.back() == 'h') folder.remove_suffix(1);
    return folder.size() <= 2 && std::ranges::all_of(folder, is_digit);
}

// In order. What cameras, phones and programs put before a time, and what people call folders of videos.
constexpr std::array<std::string_view, 39> common_words{
    "alarm",   "archive", "capture", "cctv",   "clip",      "clips",      "continuous", "dav",
    "dvr",     "event",   "events",  "export", "exports",   "file",       "footage",    "img",
    "manual",  "mdalarm", "media",   "motion", "mov",       "movie",      "mp4",        "mvi",
    "nvr",     "pxl",     "rec",     "record", "recording", "recordings", "schedule",   "screen recording",
    "sdalarm", "segment", "timer",   "vid",    "video",     "videos",     "wp"};

}  // namespace

std::string camera_of_folders(std::string_view path, std::size_t skipped) {
    std::string camera;
    bool dated = false;
    std::size_t begin = 0;
    for (auto slash = path.find('/'); slash != std::string_view::npos; slash = path.find('/', begin)) {
        const std::string_view folder = path.substr(begin, slash - begin);
        const bool counts = begin >= skipped;
        begin = slash + 1;
        if (dated && is_part_of_date(folder)) continue;
        if (is_date(folder)) {
            if (!camera.empty()) return camera;
            dated = true;
            continue;
        }
        if (!counts) continue;
        if (dated) return std::string(folder);
        if (!camera.empty()) camera += '/';
        camera += folder;
    }
    return camera;
}

bool is_generic_name(std::string_view name) {
    constexpr std::string_view counts = "0123456789-_. #()";
    while (!name.empty() && counts.find(name.back()) != std::string_view::npos) name.remove_suffix(1);
    if (name.empty()) return true;
    std::string word(name);
    std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::ranges::binary_search(common_words, word);
}

}  // namespace vvr::video
