#include "core/footage/recording.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <string_view>
#include <system_error>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/footage/input_files.h"
#include "core/media/container.h"
#include "core/media/demuxer.h"
#include "core/media/input.h"

namespace vvr::footage {

namespace {

namespace fs = std::filesystem;

using Files = std::vector<std::string>;

// ---- Which files

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
    if (name == "-" || (media::is_url(name) && !fs::exists(status))) return true;
    if (fs::is_directory(status)) return holds_pictures(name) || video_files_in(name).empty();
    if (fs::exists(status)) return !fs::is_regular_file(status);
    const std::vector<std::string> found = expand_glob(name);
    return std::ranges::none_of(found, [](const std::string& match) {
        std::error_code ignored;
        return is_video_name(match) || (fs::is_directory(match, ignored) && !is_single_source(match));
    });
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

/// Sorts files by name, and removes repeated ones, also if they are spelled differently or reached through links.
/// \returns how many were repeated
std::size_t sort_once(Files& files) {
    std::error_code none;
    // Of a file and a link to it, such as "latest.mp4", the file stays: its name may tell when it was recorded.
    std::stable_partition(files.begin(), files.end(),
                          [&](const std::string& file) { return !fs::is_symlink(file, none); });
    std::unordered_set<std::string> seen;
    const std::size_t repeats = std::erase_if(files, [&](const std::string& file) {
        const fs::path place = fs::canonical(file, none);
        return !seen.insert(none ? whole_path(file) : place.string()).second;
    });
    std::ranges::sort(files, natural_less);
    return repeats;
}

[[noreturn]] void refuse_part(const std::string& name) {
    std::error_code none;
    if (name == "-" || media::is_url(name)) {
        throw Error(ErrorCode::input_unsuitable,
                    fmt::format("cannot join '{}' with other inputs: it is a stream, not a file; give it alone", name));
    }
    if (!fs::exists(name, none)) media::open_file(name);  // throws
    throw Error(
        ErrorCode::input_unsuitable,
        fmt::format("cannot join '{}' with other inputs: it has no video files; give video files, or folders of "
                    "them",
                    name));
}

/// Checks that a file that doesn't look like one is a video. Other files are checked when they are read.
void require_video(const std::string& name) {
    std::error_code none;
    if (!fs::is_regular_file(name, none) || is_list(name) || is_video_name(name)) return;
    media::Demuxer(media::open_input(name), media::Demuxer::Kind::video, 0);  // throws
}

// ---- Related files

bool are_alike(const media::ClipHeader& a, const media::ClipHeader& b) {
    constexpr double tolerance = 0.1;  // relative; a camera's frame rate varies between files
    const bool rates = a.rate <= 0 || b.rate <= 0 || std::abs(a.rate - b.rate) <= tolerance * std::max(a.rate, b.rate);
    return a.picture == b.picture && rates;
}

std::string text_of(const media::ClipHeader& header) {
    return fmt::format("{}x{} at {:.3g} frames per second", header.picture.width, header.picture.height, header.rate);
}

/// The header of a segment's file.
struct SegmentHeader {
    Segment* segment = nullptr;
    media::ClipHeader header;
};

/// Whether file names differ only in numbers, as a recorder counts its files: "clip1.mp4", "clip2.mp4".
bool are_numbered(const std::vector<Segment>& segments) {
    const auto without_digits = [](const Segment& segment) {
        std::string name = fs::path(segment.path).filename().string();
        std::erase_if(name, is_digit);
        return name;
    };
    const std::string first = without_digits(segments.front());
    return std::ranges::all_of(segments, [&](const Segment& each) { return without_digits(each) == first; });
}

/// Checks that files whose names have no time belong to the recording: their picture sizes and frame rates must agree.
/// If no name has a time, the names must differ only in numbers.
///
/// \param headers of these files, preceded by that of one file whose name has a time, if there is one
/// \throws Error usage if they differ
void require_related(const Recording& recording, std::span<const SegmentHeader> headers) {
    for (const auto& [segment, header] : headers) {
        const SegmentHeader& first = headers.front();
        if (are_alike(first.header, header)) continue;
        throw Error(
            ErrorCode::recording_mixed,
            fmt::format("'{}' ({}) and '{}' ({}) seem unrelated: {} when it was recorded; give one of the {}, or "
                        "join them as one recording",
                        first.segment->path, text_of(first.header), segment->path, text_of(header),
                        first.segment->begin ? "the name of the second does not say" : "no name says",
                        counted(std::ssize(recording.segments), "file")),
            {"join"});
    }
    const std::vector<Segment>& segments = recording.segments;
    const bool dated = std::ranges::any_of(segments, [](const Segment& each) { return each.begin.has_value(); });
    if (dated || are_numbered(segments)) return;
    throw Error(
        ErrorCode::recording_mixed,
        fmt::format("'{}' and '{}' seem unrelated: no name says when it was recorded, and their names differ by "
                    "more than a number; give one of the {}, or join them as one recording",
                    segments.front().path, segments[1].path, counted(std::ssize(segments), "file")),
        {"join"});
}

// ---- Start times

/// The headers of files whose names have no time, preceded by that of one file whose name has a time.
/// \param rate as SourceOptions::rate
std::vector<SegmentHeader> headers_of(std::vector<Segment>& segments, double rate) {
    std::vector<Segment*> read;
    const auto dated = std::ranges::find_if(segments, [](const Segment& each) { return each.begin.has_value(); });
    if (dated != segments.end()) read.push_back(&*dated);
    for (Segment& segment : segments) {
        if (!segment.begin) read.push_back(&segment);
    }
    std::vector<SegmentHeader> headers;
    if (dated != segments.end() && read.size() == 1) return headers;
    for (Segment* const segment : read) {
        try {
            headers.push_back({segment, media::header_of(media::Demuxer(media::open_input(segment->path),
                                                                        media::Demuxer::Kind::video, rate))});
        } catch (const Error& error) {
            if (error.code() == ErrorCode::out_of_memory) throw;
            continue;  // reported when it is read
        }
    }
    return headers;
}

/// Whether the times are plausible for consecutive files: few files begin before the previous one ends.
/// \param spans begin and end of each file, seconds
/// \param share maximum share of files that overlap
bool follow_each_other(std::vector<std::pair<double, double>> spans, double share) {
    constexpr double most_overlap = 5;  // seconds
    std::ranges::sort(spans);
    std::size_t wrong = 0;
    for (std::size_t i = 1; i < spans.size(); ++i) {
        const auto& [begin, end] = spans[i - 1];
        wrong += spans[i].first + std::min(most_overlap, (end - begin) / 2) < end ? 1 : 0;
    }
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
    const auto warn = [&](std::string_view rest) {
        if (recording.segments.size() == 1) return;  // it has no order
        const std::string files = undated == std::ssize(recording.segments)
                                      ? "the names of its files do not say"
                                      : fmt::format("the names of {} do not say", counted(undated, "file"));
        recording.warnings.push_back(fmt::format("'{}': {} when it was recorded{}", recording.name, files, rest));
    };
    if (try_times(ClockSource::container, 0.4, [](const SegmentHeader& file) -> std::optional<double> {
            if (!file.header.created) return std::nullopt;
            return static_cast<double>(*file.header.created);
        })) {
        warn(
            "; vvr orders them by the creation times in their containers, which are times of day only with "
            "--start-time container");
        return;
    }
    // Copying sets a new modification time. Wrong times would make files overlap, and overlaps are omitted.
    if (try_times(ClockSource::modified, 0.05, [](const SegmentHeader& file) -> std::optional<double> {
            if (file.header.length <= 0) return std::nullopt;
            return modified_at(file.segment->path).value_or(0) - file.header.length;
        })) {
        warn(
            ", nor do their containers; vvr orders them by their modification times, which are times of day only with "
            "--start-time modified");
        return;
    }
    warn(", and their creation and modification times contradict each other; vvr orders them by their names");
}

/// The length in a file's header, seconds; 0 if it has none or can't be read.
double length_in_header(const std::string& path) {
    try {
        return media::header_of(media::Demuxer(media::open_input(path), media::Demuxer::Kind::video, 0)).length;
    } catch (const Error& error) {
        if (error.code() == ErrorCode::out_of_memory) throw;
        return 0;  // reported when it is read
    }
}

/// When a file begins whose name has this time. In the hour that repeats at the end of daylight saving time, the file's
/// modification time decides: that is when the file ended.
std::int64_t begin_from_name(const std::string& path, const NamedTime& time) {
    const std::int64_t first = utc_of(time);
    const double written = modified_at(path).value_or(0);
    const std::int64_t second = utc_of(time, std::llround(written));
    if (second == first) return first;  // it is the only one, or the file ended near it
    if (const double length = length_in_header(path); length > 0) return utc_of(time, std::llround(written - length));
    return static_cast<double>(second) < written ? second : first;
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

/// Leaves out the files of a camera's small stream that begin with one of its large stream.
void leave_out_sub_streams(Recording& recording) {
    constexpr std::int64_t together = 5;  // seconds
    std::set<std::int64_t> mains;
    for (const Segment& each : recording.segments) {
        if (each.begin && !each.sub) mains.insert(*each.begin);
    }
    const std::size_t files = std::erase_if(recording.segments, [&](const Segment& each) {
        if (!each.sub || !each.begin) return false;
        const auto near = mains.lower_bound(*each.begin - together);
        return near != mains.end() && *near <= *each.begin + together;
    });
    if (files == 0) return;
    recording.warnings.push_back(
        fmt::format("'{}': {} of the camera's small stream {} not drawn: the large stream has "
                    "the same times",
                    recording.name, counted(static_cast<std::int64_t>(files), "file"), files == 1 ? "is" : "are"));
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

/// If the files state more frames per second than the camera sends, they are read at the rate at which they fill their
/// time.
void set_steady_rate(Recording& recording) {
    constexpr double slack = 0.05;  // of the time of a file
    const auto steady = find_steady_rate(recording.segments);
    if (!steady) return;
    recording.rate = steady->rate;
    for (Segment& segment : recording.segments) segment.slack += slack * steady->pace;
    recording.warnings.push_back(fmt::format(
        "'{}': each file has {:.0f} s of the {:.0f} s until the next begins. The camera seems to send {:.3g} frames "
        "per "
        "second, not the {:.3g} that its files state, so vvr reads them at this rate; --rate {:.3g} keeps the times of "
        "the files, with gaps",
        recording.name, steady->length, steady->pace, steady->rate, steady->stated, steady->stated));
}

}  // namespace

SegmentBegin begin_of(const Segment& segment, std::optional<std::int64_t> origin, std::optional<double> end) {
    if (!end) return {};
    if (!segment.begin || !origin) return {*end, true, false};
    const double begin = static_cast<double>(*segment.begin - *origin);
    if (std::abs(begin - *end) <= segment.slack) return {*end, true, false};
    return {begin, false, begin < *end};
}

Segment segment_from_name(const std::string& path, const RecorderNames& schemes) {
    RecorderName name = schemes.read(whole_path(path));
    Segment segment{path};
    segment.camera = std::move(name.camera);
    segment.scheme = std::move(name.scheme);
    segment.sub = name.sub;
    segment.no_clock = name.no_clock;
    if (name.begin) {
        segment.begin = begin_from_name(path, *name.begin);
        segment.begin_source = ClockSource::file_name;
    }
    return segment;
}

std::vector<std::string> files_of_inputs(std::span<const std::string> names) {
    Files files;
    for (const std::string& name : names) {
        if (!is_single_source(name)) add_files(name, files);
    }
    sort_once(files);
    return files;
}

std::optional<Recording> find_recording(std::span<const std::string> names, const RecorderNames& known, bool join,
                                        double rate) {
    if (names.size() == 1) {
        std::error_code none;
        const bool single = fs::is_regular_file(names.front(), none) && !is_list(names.front());
        if (single || is_single_source(names.front())) return std::nullopt;
    }
    std::vector<std::string> files;
    for (const std::string& name : names) {
        if (is_single_source(name)) refuse_part(name);
        require_video(name);
        add_files(name, files);
    }
    const std::size_t repeats = sort_once(files);
    if (files.empty()) {
        throw Error(ErrorCode::file_invalid,
                    fmt::format("the list '{}' is empty; write the path of a video file in each line", names.front()));
    }
    Recording recording{name_of(names, files), {}, {}};
    if (repeats > 0) {
        recording.warnings.push_back(fmt::format("'{}': {} given more than once; each is read once", recording.name,
                                                 repeats == 1 ? "1 file is" : fmt::format("{} files are", repeats)));
    }
    RecorderNames schemes = known;
    Files paths;
    for (const std::string& file : files) paths.push_back(whole_path(file));
    schemes.compare(paths);
    for (const std::string& file : files) recording.segments.push_back(segment_from_name(file, schemes));
    recording.camera = find_camera(recording.name, recording.segments, schemes, join);
    leave_out_sub_streams(recording);
    if (const auto unset = std::ranges::count_if(recording.segments, &Segment::no_clock); unset > 0)
        recording.warnings.push_back(fmt::format("'{}': {}", recording.name, text_of_unset_clocks(unset)));
    const std::vector<SegmentHeader> headers = headers_of(recording.segments, rate);
    if (!join) require_related(recording, headers);
    set_times_of_containers(recording, headers);
    sort_by_time(recording.segments);
    recording.rate = rate;
    if (rate == 0) set_steady_rate(recording);
    return recording;
}

}  // namespace vvr::footage
