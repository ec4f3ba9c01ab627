#include "core/footage/camera_names.h"

#include <algorithm>
#include <array>

#include <re2/re2.h>

#include <fmt/format.h>

#include "core/base/file.h"
#include "core/base/text.h"

namespace vvr::footage {

namespace {

/// A year followed only by numbers: 2026, 2026-11, 20261121, 2026_11_21, 2026-11-21_20.
bool is_date(std::string_view folder) {
    const bool year = folder.size() >= 4 && (folder.starts_with("19") || folder.starts_with("20")) &&
                      std::ranges::all_of(folder.substr(0, 4), is_digit);
    if (folder.size() == 14 && folder[4] == 'Y' && folder.back() == 'H') return year;  // 2026Y11M21D20H
    if (folder.ends_with("AM") || folder.ends_with("PM")) folder.remove_suffix(2);
    if (!year || folder.size() == 5 || folder.size() > 13) return false;
    return std::ranges::all_of(folder.substr(4),
                               [](char c) { return is_digit(c) || c == '-' || c == '_' || c == '.'; });
}

/// Whether a folder is a date or a part of one: month, day or hour ("20", "20h").
bool is_part_of_date(std::string_view folder) {
    if (is_date(folder)) return true;
    if (folder.size() == 3 && folder.back() == 'h') folder.remove_suffix(1);
    return folder.size() <= 2 && std::ranges::all_of(folder, is_digit);
}

/// Whether a folder is one of a card (DCF): "100EK113" and the next, "101EK113".
bool is_of_card(std::string_view folder) {
    static const re2::RE2 form("DCIM|[1-9][0-9]{2}(?:[0-9A-Z_]{4}[A-Z_]|[A-Z_][0-9A-Z_]{4})");
    return re2::RE2::FullMatch(re2::StringPiece(folder.data(), folder.size()), form);
}

// Sorted. Prefixes that cameras, phones and programs use before a time, and common names of video folders.
constexpr std::array<std::string_view, 39> common_words{
    "alarm",   "archive", "capture", "cctv",   "clip",      "clips",      "continuous", "dav",
    "dvr",     "event",   "events",  "export", "exports",   "file",       "footage",    "img",
    "manual",  "mdalarm", "media",   "motion", "mov",       "movie",      "mp4",        "mvi",
    "nvr",     "pxl",     "rec",     "record", "recording", "recordings", "schedule",   "screen recording",
    "sdalarm", "segment", "timer",   "vid",    "video",     "videos",     "wp"};

/// Without a number at the end: "clip" of "clip 7", "" of "001".
std::string_view without_number(std::string_view name) {
    const auto last = name.find_last_not_of("0123456789-_. #()");
    return name.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

/// Whether a name begins with an IPv4 address, as many cameras name their files.
bool begins_with_address(std::string_view name) {
    static const re2::RE2 address("(?:[0-9]{1,3}\\.){3}[0-9]{1,3}(?:[^0-9.].*)?");
    return re2::RE2::FullMatch(re2::StringPiece(name.data(), name.size()), address);
}

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
        if (!counts || is_of_card(folder)) continue;
        if (dated) return std::string(folder);
        if (!camera.empty()) camera += '/';
        camera += folder;
    }
    return camera;
}

bool is_generic_name(std::string_view name) {
    const std::string_view word = without_number(name);
    if (word.empty()) return !begins_with_address(name);
    return std::ranges::binary_search(common_words, lower_case(word));
}

std::string numbered_with(std::string_view path, std::string_view numbered) {
    return fmt::format("{}/{}", camera_of_folders(path, 0), without_number(numbered));
}

}  // namespace vvr::footage
