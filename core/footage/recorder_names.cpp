#include "core/footage/recorder_names.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <system_error>
#include <utility>

#include <re2/re2.h>

#include <fmt/format.h>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/base/wall_clock.h"

namespace vvr::footage {

namespace {

// Which parts of a path may name a camera.

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

/// The folders before the first date folder, or else the first folder after it that is not a date or hour. Empty if
/// there is none.
/// \param skipped leading bytes of `path` whose folders are not a camera, but may be a date
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

/// Whether a name is generic, not a camera's: "VID", "clip 7", "recordings", "001".
bool is_generic_name(std::string_view name) {
    const std::string_view word = without_number(name);
    if (word.empty()) return !begins_with_address(name);
    return std::ranges::binary_search(common_words, lower_case(word));
}

/// Files with the same result are numbered together: the folders of their camera, and the word before the number.
/// \param numbered a generic name with a number: "video1"
std::string numbered_with(std::string_view path, std::string_view numbered) {
    return fmt::format("{}/{}", camera_of_folders(path, 0), without_number(numbered));
}

/// A file with a number before the time.
struct NumberedFile {
    std::int64_t begin = 0;
    std::string name;
};

/// Whether the numbers of files are cameras: at least half of the files have a number that others have too, or begin
/// with a file of another number. A count of files does neither.
bool are_of_cameras(std::vector<NumberedFile> files) {
    constexpr std::int64_t together = 1;  // seconds
    std::ranges::sort(files, {}, &NumberedFile::begin);
    std::map<std::string_view, int> files_of;
    for (const NumberedFile& file : files) ++files_of[file.name];
    const auto is_parallel = [&](std::size_t a, std::size_t b) {
        return b < files.size() && files[b].begin - files[a].begin <= together && files[a].name != files[b].name;
    };
    std::size_t telling = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const bool parallel = is_parallel(i, i + 1) || (i > 0 && is_parallel(i - 1, i));
        telling += parallel || files_of[files[i].name] > 1 ? 1 : 0;
    }
    return 2 * telling >= files.size();
}

constexpr std::string_view given_by_user = "--names";

/// Without ".mp4", but with the ".07" of "08.00.07".
std::string_view without_extension(std::string_view path) {
    const auto dot = path.rfind('.');
    const auto slash = path.rfind('/');
    if (dot == std::string_view::npos || (slash != std::string_view::npos && dot < slash)) return path;
    const std::string_view ending = path.substr(dot + 1);
    const bool number = ending.size() <= 2 && std::ranges::all_of(ending, is_digit);
    return number ? path : path.substr(0, dot);
}

bool all_digits(std::string_view text) {
    return std::ranges::all_of(text, is_digit);
}

/// Whether a clock shows such a time because it was never set: it began to count in 1970, 1980 or 2000.
bool was_never_set(std::int64_t clock) {
    constexpr std::int64_t year_1990 = 631'152'000;
    constexpr std::int64_t year_2000 = 946'684'800;
    constexpr std::int64_t two_days = 172'800;
    return clock < year_1990 || (clock >= year_2000 && clock < year_2000 + two_days);
}

/// The folder of a path, with its '/'.
std::string_view with_folder(std::string_view path) {
    return path.substr(0, path.rfind('/') + 1);
}

/// Whether a text before the time has another date and time: of two, the first is when the recording begins.
bool has_moment(const std::string& camera) {
    static const re2::RE2 moment(
        R"((?:19|20)\d\d[-_.]?(?:0[1-9]|1[0-2])[-_.]?[0-3]\d(?:[-_. T@]| - |__)?[0-2]\d[-_.:h]?[0-5]\d)",
        re2::RE2::Latin1);
    return re2::RE2::PartialMatch(camera, moment);
}

std::vector<NamingScheme> schemes_of(std::span<const std::string> patterns) {
    std::vector<NamingScheme> schemes;
    for (const std::string& pattern : patterns) {
        RecorderRow row{given_by_user, expression_of(pattern)};
        NameExpression expression(row.expression);
        schemes.push_back({std::move(row), std::move(expression)});
    }
    return schemes;
}

const std::vector<NamingScheme>& known_schemes() {
    static const std::vector<NamingScheme> known = [] {
        std::vector<NamingScheme> schemes;
        for (RecorderRow& row : recorder_rows()) {
            NameExpression expression(row.expression);
            schemes.push_back({std::move(row), std::move(expression)});
        }
        return schemes;
    }();
    return known;
}

}  // namespace

std::int64_t utc_of(const NamedTime& time, std::optional<std::int64_t> near) {
    return time.ahead ? time.clock - *time.ahead : utc_of_local(time.clock, near);
}

std::optional<RecorderName> RecorderNames::read_as(const NamingScheme& scheme, std::string_view path) const {
    const RecorderRow& row = scheme.row;
    const std::string_view stem = without_extension(path);
    std::optional<NameFields> fields = scheme.expression.read(stem);
    if (!fields && stem.size() < path.size()) fields = scheme.expression.read(path);
    if (!fields) return std::nullopt;
    const bool own = row.recorder == given_by_user;
    RecorderName name{std::string(row.recorder), (*fields)["camera"], row.camera != NamedCamera::whole};
    if (!own && has_moment(name.camera)) return std::nullopt;
    name.sub = fields->contains("sub");
    const bool counts = row.camera == NamedCamera::folder && all_digits(name.camera);
    if (name.below && !counts && is_generic_name(name.camera)) {
        if (std::ranges::any_of(name.camera, is_digit)) name.numbered = name.camera;
        name.camera.clear();
    }
    const bool swapped = row.doubt == Ambiguity::day_or_month && number_of(*fields, "d") <= 12 &&
                         number_of(*fields, "d") != number_of(*fields, "m") &&
                         !month_first_.contains(with_folder(path));
    const bool repeated = row.doubt == Ambiguity::repeated_hour && number_of(*fields, "H") == number_of(*fields, "M");
    name.ambiguous = swapped || repeated || row.doubt == Ambiguity::always || (!own && fields->contains("unread"));
    if (name.ambiguous) return name;
    name.shows_month = row.doubt == Ambiguity::day_or_month && number_of(*fields, "d") > 12;
    name.begin = time_of(*fields, row.zone == NamedZone::utc);
    const bool timed = std::ranges::any_of(std::array{"H", "I", "s", "ms"},
                                           [&](const char* field) { return fields->contains(field); });
    if (timed && !name.begin) return std::nullopt;  // such as February 31
    name.no_clock = name.begin && was_never_set(name.begin->clock);
    if (name.no_clock) name.begin.reset();
    return name;
}

RecorderNames::RecorderNames(std::span<const std::string> patterns, const std::filesystem::path& base)
    : own_(schemes_of(patterns)) {
    if (base.empty()) return;
    std::error_code none;
    folder_ = std::filesystem::absolute(base, none).lexically_normal().string();
    if (!folder_.ends_with('/')) folder_ += '/';
}

std::string RecorderNames::whole(std::string_view path) const {
    return folder_ + std::string(path);
}

void RecorderNames::describe_camera(const std::string& camera, std::span<const std::string> patterns) {
    std::ranges::move(schemes_of(patterns), std::back_inserter(of_cameras_[camera]));
}

RecorderName RecorderNames::read(std::string_view path) const {
    const std::string all = whole(path);
    RecorderName name = read_whole(all);
    if (of_cameras_.empty()) return name;
    std::vector<std::string> cameras;
    for (const auto& [camera, schemes] : of_cameras_) cameras.push_back(camera);
    const auto own = of_cameras_.find(name_of_camera(camera_of(name, all, 0), cameras));
    if (own == of_cameras_.end()) return name;
    RecorderName described = read_with(all, own->second, {});
    if (!described.begin) return name;
    described.camera = std::move(name.camera);
    described.below = name.below;
    return described;
}

/// The user's schemes come before those of known recorders.
RecorderName RecorderNames::read_whole(std::string_view whole_path) const {
    return read_with(whole_path, own_, known_schemes());
}

RecorderName RecorderNames::read_with(std::string_view whole_path, std::span<const NamingScheme> first,
                                      std::span<const NamingScheme> second) const {
    RecorderName name;
    for (std::size_t i = 0; i < first.size() + second.size(); ++i) {
        std::optional<RecorderName> read = read_as(i < first.size() ? first[i] : second[i - first.size()], whole_path);
        if (!read) continue;
        if (name.scheme.empty()) name.scheme = std::move(read->scheme);
        if (name.camera.empty()) {
            name.camera = std::move(read->camera);
            name.below = read->below;
            name.numbered = std::move(read->numbered);
        }
        name.begin = read->begin;
        name.ambiguous = read->ambiguous;
        name.no_clock = read->no_clock;
        name.sub = name.sub || read->sub;
        name.shows_month = read->shows_month;
        // A pattern without a time leaves the time to later patterns.
        if (name.begin || name.ambiguous || name.no_clock) break;
    }
    const bool is_camera = !name.numbered.empty() && (of_cameras_.contains(name.numbered) ||
                                                      numbered_.contains(numbered_with(whole_path, name.numbered)));
    if (name.camera.empty() && is_camera) name.camera = name.numbered;
    return name;
}

void RecorderNames::compare(std::span<const std::string> paths) {
    std::map<std::string, std::vector<NumberedFile>> files_by_key;
    for (const std::string& path : paths) {
        const std::string all = whole(path);
        RecorderName name = read_whole(all);
        if (name.shows_month) month_first_.insert(std::string(with_folder(all)));
        if (name.numbered.empty() || !name.begin) continue;
        files_by_key[numbered_with(all, name.numbered)].push_back({name.begin->clock, std::move(name.numbered)});
    }
    for (auto& [key, files] : files_by_key) {
        if (are_of_cameras(std::move(files))) numbered_.insert(key);
    }
}

std::string RecorderNames::camera_of(std::string_view path, std::size_t skipped) const {
    const std::string all = whole(path);
    return camera_of(read_whole(all), all, skipped);
}

std::string RecorderNames::camera_of(const RecorderName& name, std::string_view whole_path, std::size_t skipped) const {
    if (!name.camera.empty() && !name.below) return name.camera;
    std::string folders = camera_of_folders(whole_path, folder_.size() + skipped);
    if (name.camera.empty() || folders == name.camera || folders.ends_with('/' + name.camera)) return folders;
    if (folders.empty() || is_generic_name(folders)) return name.camera;
    return folders + '/' + name.camera;
}

std::string text_of_unset_clocks(std::int64_t files) {
    return fmt::format("{} dated 1970, or when another clock begins: the camera did not know the time",
                       files == 1 ? "1 file is" : fmt::format("{} files are", files));
}

std::string name_of_camera(std::string_view camera, std::span<const std::string> names) {
    std::string best;
    for (const std::string& name : names) {
        const bool means = camera == name || camera.ends_with('/' + name);
        if (means && name.size() > best.size()) best = name;
    }
    return best;
}

std::vector<std::string> known_recorders() {
    std::vector<std::string> names;
    for (const NamingScheme& scheme : known_schemes()) {
        const std::string_view name = scheme.row.recorder;
        if (!name.empty() && std::ranges::count(names, name) == 0) names.emplace_back(name);
    }
    return names;
}

}  // namespace vvr::footage
