#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/video/input.h"
#include "core/video/recording.h"
#include "core/video/stream_info.h"
#include "core/video/video_files.h"

namespace vvr::video {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view list_ending = ".txt";

[[noreturn]] void refuse_line(const std::string& list, std::int64_t number, std::string_view why) {
    throw Error(ErrorCode::file_invalid,
                fmt::format("'{}', line {}: {}; a list has the path of a video file in each line, below "
                            "the folder of the list",
                            list, number, why));
}

/// The files in a list. Lists are untrusted, so paths outside the list's folder are rejected.
std::vector<std::string> files_of_list(const std::string& list) {
    std::error_code none;
    if (fs::file_size(list, none) > most_list_bytes) {
        throw Error(ErrorCode::file_too_large,
                    fmt::format("'{}' is too large for a list of files: at most {} MB are read", list,
                                most_list_bytes / 1024 / 1024));
    }
    std::ifstream text(list);
    if (!text) throw Error(code_of_system_error(errno), fmt::format("cannot read '{}'; check its permissions", list));
    const fs::path folder = fs::path(list).parent_path();
    const fs::path real_folder = fs::canonical(folder.empty() ? "." : folder, none);
    std::vector<std::string> files;
    std::string line;
    for (std::int64_t number = 1; std::getline(text, line); ++number) {
        if (line.ends_with('\r')) line.pop_back();
        if (line.empty() || line.starts_with('#')) continue;
        if (!is_plain_path(line)) refuse_line(list, number, "its path leads out of the folder, or is none");
        const fs::path file = folder / line;
        const fs::path real = fs::canonical(file, none);
        if (none || !fs::is_regular_file(real, none)) {
            refuse_line(list, number, fmt::format("there is no file '{}'", file.string()));
        }
        const fs::path below = real.lexically_relative(real_folder);
        if (below.empty() || *below.begin() == "..")
            refuse_line(list, number, "it is a link that leads out of the folder");
        files.push_back(file.string());
    }
    return files;
}

bool holds_pictures(const fs::path& folder) {
    std::error_code none;
    for (fs::directory_iterator entry(folder, none); !none && entry != fs::directory_iterator();
         entry.increment(none)) {
        if (is_picture_name(entry->path().filename().string())) return true;
    }
    return false;
}

/// Whether a name is a source of its own, not files of a recording: a stream, a picture sequence, or no file at all.
bool is_single_source(const std::string& name) {
    std::error_code none;
    const fs::file_status status = fs::status(name, none);
    if (name == "-" || (is_url(name) && !fs::exists(status))) return true;
    if (fs::is_directory(status)) return holds_pictures(name) || video_files_in(name).empty();
    if (fs::exists(status)) return !fs::is_regular_file(status);
    const std::vector<std::string> found = expand_glob(name);
    return std::ranges::none_of(found, [](const std::string& match) {
        std::error_code ignored;
        return is_video_name(match) || (fs::is_directory(match, ignored) && !is_single_source(match));
    });
}

/// Whether a file is a list. Its content decides too, because a video may have any name.
bool is_list(const std::string& name) {
    std::error_code none;
    if (extension_of(name) != list_ending || !fs::is_regular_file(name, none)) return false;
    std::array<char, 512> begin{};
    std::ifstream file(name, std::ios::binary);
    file.read(begin.data(), begin.size());
    return std::none_of(begin.begin(), begin.begin() + file.gcount(), [](char c) { return c >= 0 && c < '\t'; });
}

void add_files(const std::string& name, std::vector<std::string>& files) {
    std::error_code none;
    const auto add = [&files](const std::vector<std::string>& more) {
        files.insert(files.end(), more.begin(), more.end());
    };
    if (fs::is_directory(name, none)) {
        add(video_files_in(name));
    } else if (is_list(name)) {
        add(files_of_list(name));
    } else if (fs::exists(name, none)) {
        files.push_back(name);
    } else {
        for (const std::string& match : expand_glob(name)) add_files(match, files);
    }
}

[[noreturn]] void refuse_part(const std::string& name) {
    std::error_code none;
    if (name == "-" || is_url(name)) {
        throw Error(ErrorCode::input_unsuitable,
                    fmt::format("'{}' is a stream, and only files can be one recording together", name));
    }
    if (!fs::exists(name, none)) open_file(name);  // throws
    throw Error(ErrorCode::input_unsuitable,
                fmt::format("'{}' holds no video files, so it can't be a part of one recording with "
                            "the others; give video files, or folders of them",
                            name));
}

// ---- Start times

/// The headers of files whose names have no time, preceded by that of one file whose name has a time.
std::vector<SegmentHeader> headers_of(std::vector<Segment>& segments) {
    std::vector<Segment*> looked_at;
    const auto told = std::ranges::find_if(segments, [](const Segment& each) { return each.begin.has_value(); });
    if (told != segments.end()) looked_at.push_back(&*told);
    for (Segment& segment : segments) {
        if (!segment.begin) looked_at.push_back(&segment);
    }
    std::vector<SegmentHeader> headers;
    if (told != segments.end() && looked_at.size() == 1) return headers;
    for (Segment* const segment : looked_at) {
        try {
            headers.push_back({segment, header_of(Demuxer(open_input(segment->path), Demuxer::Kind::video, 25))});
        } catch (const Error&) {
            continue;  // reported when it is read
        }
    }
    return headers;
}

/// Whether the times are plausible for consecutive files: few files begin before the previous one ends.
/// \param spans begin and end of each file, seconds
/// \param share maximum share of files that overlap
bool follow_each_other(std::vector<std::pair<double, double>> spans, double share) {
    constexpr double overlap = 5;  // seconds
    std::ranges::sort(spans);
    std::size_t wrong = 0;
    for (std::size_t i = 1; i < spans.size(); ++i) wrong += spans[i].first + overlap < spans[i - 1].second ? 1 : 0;
    return static_cast<double>(wrong) <= share * static_cast<double>(spans.size());
}

void set_times_of_containers(Recording& recording, std::span<const SegmentHeader> headers) {
    const auto undated = std::ranges::count_if(recording.segments, [](const Segment& each) { return !each.begin; });
    if (undated == 0) return;
    std::vector<SegmentHeader> read;
    std::ranges::copy_if(headers, std::back_inserter(read), [](const auto& each) { return !each.segment->begin; });
    const auto try_times = [&](ClockSource source, double share,
                               const std::function<std::optional<double>(const SegmentHeader&)>& begin_of) {
        std::vector<std::pair<double, double>> spans;
        std::vector<std::optional<double>> begins;
        for (const SegmentHeader& file : read) {
            begins.push_back(begin_of(file));
            if (!begins.back() && file.header.length > 0) return false;
            if (begins.back()) spans.emplace_back(*begins.back(), *begins.back() + file.header.length);
        }
        if (spans.empty() || !follow_each_other(spans, share)) return false;
        for (std::size_t i = 0; i < read.size(); ++i) {
            if (!begins[i]) continue;
            read[i].segment->begin = std::llround(*begins[i]);
            read[i].segment->begin_source = source;
        }
        return true;
    };
    const std::string files = undated == std::ssize(recording.segments)
                                  ? "its files' names do not tell"
                                  : fmt::format("the names of {} do not tell", counted(undated, "file"));
    if (try_times(ClockSource::container, 0.4, [](const SegmentHeader& file) -> std::optional<double> {
            if (!file.header.created) return std::nullopt;
            return static_cast<double>(*file.header.created);
        })) {
        recording.warnings.push_back(fmt::format(
            "'{}': {} when it was recorded, so each is placed by when its container says it was written; times of day "
            "are not shown (--start-time container shows these)",
            recording.name, files));
        return;
    }
    // Copying sets a new modification time. Wrong times would make files overlap, and overlaps are omitted.
    if (try_times(ClockSource::modified, 0.05, [](const SegmentHeader& file) -> std::optional<double> {
            if (file.header.length <= 0) return std::nullopt;
            return modified_at(file.segment->path).value_or(0) - file.header.length;
        })) {
        recording.warnings.push_back(fmt::format(
            "'{}': {} when it was recorded, nor do containers, so each is taken to end when the file was last written; "
            "times of day are not shown (--start-time modified shows these)",
            recording.name, files));
        return;
    }
    recording.warnings.push_back(fmt::format(
        "'{}': {} when it was recorded, and the times at which the files were written contradict each other; "
        "they follow each other by their names",
        recording.name, files));
}

/// Sorts by start time. A file without one stays behind its predecessor by name.
void sort_by_time(std::vector<Segment>& segments) {
    std::optional<std::int64_t> before;
    std::vector<std::pair<std::int64_t, Segment>> keyed;
    for (Segment& segment : segments) {
        if (segment.begin) before = segment.begin;
        keyed.emplace_back(before.value_or(std::numeric_limits<std::int64_t>::min()), std::move(segment));
    }
    std::ranges::stable_sort(keyed, {}, [](const auto& entry) { return entry.first; });
    segments.clear();
    for (auto& entry : keyed) segments.push_back(std::move(entry.second));
}

/// A name for the recording: the given name, or the common folder of all files.
std::string name_of(std::span<const std::string> names, const std::vector<std::string>& files) {
    if (names.size() == 1) return names.front();
    fs::path common = fs::path(files.front()).parent_path();
    for (const std::string& file : files) {
        while (!common.empty()) {
            const fs::path below = fs::path(file).lexically_relative(common);
            if (!below.empty() && *below.begin() != "..") break;
            common = common.has_relative_path() ? common.parent_path() : fs::path();
        }
    }
    return common.empty() || !common.has_filename() ? files.front() : common.string();
}

}  // namespace

SegmentBegin begin_of(const Segment& segment, std::optional<std::int64_t> origin, std::optional<double> end) {
    constexpr double tolerance = 1;
    if (!end) return {};
    if (!segment.begin || !origin) return {*end, true, false};
    const double begin = static_cast<double>(*segment.begin - *origin);
    if (std::abs(begin - *end) <= tolerance) return {*end, true, false};
    return {begin, false, begin < *end};
}

Segment segment_from_name(const std::string& path, const RecorderNames& layouts) {
    RecorderName told = layouts.read(whole_path(path));
    Segment segment{path};
    segment.camera = std::move(told.camera);
    segment.layout = std::move(told.layout);
    if (told.begin) {
        segment.begin = utc_of(*told.begin, std::llround(modified_at(path).value_or(0)));
        segment.begin_source = ClockSource::file_name;
    }
    return segment;
}

std::optional<Recording> find_recording(std::span<const std::string> names, const RecorderNames& layouts, bool join) {
    if (names.size() == 1) {
        std::error_code none;
        const bool single = fs::is_regular_file(names.front(), none) && !is_list(names.front());
        if (single || is_single_source(names.front())) return std::nullopt;
    }
    std::vector<std::string> files;
    for (const std::string& name : names) {
        if (is_single_source(name)) refuse_part(name);
        add_files(name, files);
    }
    std::ranges::sort(files, natural_less);
    files.erase(std::unique(files.begin(), files.end()), files.end());
    if (files.empty()) {
        throw Error(ErrorCode::file_invalid,
                    fmt::format("'{}' names no file; it has the path of a video file in each line", names.front()));
    }
    Recording recording{name_of(names, files), {}, {}};
    for (const std::string& file : files) recording.segments.push_back(segment_from_name(file, layouts));
    recording.camera = find_camera(recording.name, recording.segments, layouts, join);
    const std::vector<SegmentHeader> headers = headers_of(recording.segments);
    if (!join) require_related(recording, headers);
    set_times_of_containers(recording, headers);
    sort_by_time(recording.segments);
    return recording;
}

}  // namespace vvr::video
