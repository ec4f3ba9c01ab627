#include "core/footage/open_source.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/footage/input_files.h"
#include "core/footage/recording.h"
#include "core/footage/recording_source.h"
#include "core/footage/segments.h"
#include "core/media/demuxer.h"
#include "core/media/file_source.h"
#include "core/media/input.h"
#include "core/media/picture_source.h"
#include "core/media/settings.h"

namespace vvr::footage {

namespace {

/// Pictures that a camera saved now and then, each with the time of its name.
struct Snapshots {
    std::string camera;                       ///< empty = unknown
    std::int64_t begin = 0;                   ///< of the first, seconds since 1970 (UTC)
    double usual = 0;                         ///< time between two of them, seconds
    std::vector<media::SegmentPlace> places;  ///< in order; numbers are left out where pictures are missing
    std::vector<std::string> warnings{};      ///< one sentence each
};

/// Seconds from the first of some times on, ascending. Of n equal times, each but the first is 1/n later.
std::vector<double> spread_times(const std::vector<Segment>& segments) {
    std::vector<double> times;
    for (auto next = segments.begin(); next != segments.end();) {
        const std::int64_t begin = next->begin.value();
        const auto end = std::find_if(next, segments.end(), [=](const Segment& one) { return one.begin != begin; });
        const auto second = static_cast<double>(begin - segments.front().begin.value());
        const auto count = static_cast<double>(end - next);
        for (double k = 0; next != end; ++next, ++k) times.push_back(second + k / count);
    }
    return times;
}

double usual_distance(const std::vector<double>& times) {
    std::vector<double> apart;
    for (std::size_t i = 1; i < times.size(); ++i) apart.push_back(times[i] - times[i - 1]);
    const auto middle = apart.begin() + std::ssize(apart) / 2;
    std::ranges::nth_element(apart, middle);
    return *middle;
}

/// Finds out when pictures were taken. A distance of more than three times the usual one is a gap. Several pictures of
/// one second are spread over it.
/// \param name of the input, for messages
/// \param files in natural order
/// \param join as in `find_recording`
/// \returns nothing if most names have no time, or if all have the same one
/// \throws Error usage if they are of several cameras
std::optional<Snapshots> find_snapshots(const std::string& name, const std::vector<std::string>& files,
                                        const RecorderNames& known, bool join) {
    constexpr double wide = 3;  // usual distances
    constexpr double far = 5;   // seconds; within them, people leave the place where they were
    RecorderNames schemes = known;
    std::vector<std::string> paths;
    for (const std::string& file : files) paths.push_back(whole_path(file));
    schemes.compare(paths);
    std::vector<Segment> segments;
    std::vector<std::string> undated;
    for (const std::string& file : files) {
        Segment segment = segment_from_name(file, schemes);
        if (segment.begin) {
            segments.push_back(std::move(segment));
        } else {
            undated.push_back(file);
        }
    }
    if (segments.size() < 2 || segments.size() <= undated.size()) return std::nullopt;
    std::ranges::stable_sort(segments, {}, &Segment::begin);
    Snapshots found;
    found.camera = find_camera(name, segments, schemes, join);
    found.begin = *segments.front().begin;
    const std::vector<double> times = spread_times(segments);
    found.usual = usual_distance(times);
    std::int64_t number = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const double apart = i + 1 < segments.size() ? times[i + 1] - times[i] : found.usual;
        const bool gap = apart > wide * found.usual;
        found.places.push_back({segments[i].path, times[i], times[i] + (gap ? found.usual : apart), number});
        number += gap ? std::llround(apart / found.usual) : 1;
    }
    if (found.usual > far) {
        found.warnings.push_back(
            fmt::format("'{}': its pictures are {:.0f} s apart. What happened between two of them is not known, and so "
                        "its events are guesses",
                        name, found.usual));
    }
    if (!undated.empty()) {
        found.warnings.push_back(fmt::format("'{}': {} whose name has no time left out, such as '{}'", name,
                                             counted(std::ssize(undated), "picture"), undated.front()));
    }
    return found;
}

/// A warning if a folder of pictures also has videos, which are ignored.
std::optional<std::string> videos_beside_pictures(const std::string& folder) {
    std::error_code none;
    if (!std::filesystem::is_directory(folder, none)) return std::nullopt;
    std::vector<std::string> videos = video_files_in(folder);
    if (videos.empty()) return std::nullopt;
    std::ranges::sort(videos, natural_less);
    return fmt::format("'{}' has pictures, which vvr reads as one clip; {} in it {} ignored: '{}'{}", folder,
                       counted(std::ssize(videos), "video"), videos.size() == 1 ? "is" : "are", videos.front(),
                       videos.size() == 1 ? "" : " and others");
}

/// Pictures with the times of their names; null if these have none.
/// \param files none = the input is no pictures
std::unique_ptr<media::FrameSource> open_snapshots(const std::string& name,
                                                   const std::optional<std::vector<std::string>>& files,
                                                   const media::SourceOptions& options, const RecorderNames& schemes,
                                                   std::vector<std::string>& warnings) {
    auto found = files ? find_snapshots(name, *files, schemes, options.join) : std::nullopt;
    if (!found) return nullptr;
    warnings.insert(warnings.end(), found->warnings.begin(), found->warnings.end());
    media::SourceOptions timed = options;
    timed.begin = found->begin;
    if (options.rate == 0) timed.rate = 1 / found->usual;
    for (std::size_t i = 0; options.rate > 0 && i < found->places.size(); ++i) {
        const auto number = static_cast<std::int64_t>(i);
        found->places[i] = {found->places[i].path, static_cast<double>(number) / options.rate,
                            static_cast<double>(number + 1) / options.rate, number};
    }
    return std::make_unique<media::PictureSource>(name, found->camera, std::move(found->places), timed);
}

/// Several files, if all have names of pictures.
std::optional<std::vector<std::string>> pictures_among(const std::vector<std::string>& names) {
    if (names.size() == 1 || !std::ranges::all_of(names, is_picture_name)) return std::nullopt;
    std::vector<std::string> sorted = names;
    std::ranges::sort(sorted, natural_less);
    return sorted;
}

}  // namespace

std::unique_ptr<media::FrameSource> open_source(const std::string& name, const media::SourceOptions& options) {
    if (options.rate != 0) check(setting::rate, options.rate);
    if (auto files = list_pictures(name))
        return std::make_unique<media::PictureSource>(name, std::move(*files), options);
    return std::make_unique<media::FileSource>(media::open_track(name, options.track), options);
}

std::unique_ptr<media::FrameSource> open_sources(const std::vector<std::string>& names,
                                                 const media::SourceOptions& options, const RecorderNames& schemes,
                                                 std::vector<std::string>& warnings) {
    if (options.rate != 0) check(setting::rate, options.rate);
    const std::string folder = std::filesystem::path(names.front()).parent_path().string();
    if (auto shots = open_snapshots(folder, pictures_among(names), options, schemes, warnings)) return shots;
    if (auto recording = find_recording(names, schemes, options.join, options.rate)) {
        warnings.insert(warnings.end(), recording->warnings.begin(), recording->warnings.end());
        media::SourceOptions paced = options;
        paced.rate = recording->rate;
        return std::make_unique<RecordingSource>(std::move(*recording), paced);
    }
    media::SourceOptions one = options;
    const Segment named = segment_from_name(names.front(), schemes);
    one.begin = named.begin;
    if (named.no_clock) warnings.push_back(fmt::format("'{}': {}", names.front(), text_of_unset_clocks(1)));
    const auto pictures = list_pictures(names.front());
    if (pictures && (options.track > 0 || options.aspect)) {
        warnings.push_back(fmt::format("'{}' has pictures, on which track and aspect have no effect", names.front()));
    }
    if (const auto ignored = videos_beside_pictures(names.front())) warnings.push_back(*ignored);
    if (auto shots = open_snapshots(names.front(), pictures, options, schemes, warnings)) return shots;
    if (pictures && (options.rate == 0 || schemes.has_patterns())) {
        warnings.push_back(
            fmt::format("'{}': most names of its pictures give no time, so vvr reads them at {:.6g} frames per second "
                        "(--rate gives another rate, --names describes other names)",
                        names.front(), options.rate > 0 ? options.rate : media::assumed_rate));
    }
    return open_source(names.front(), one);
}

}  // namespace vvr::footage
