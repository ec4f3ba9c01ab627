#include "core/footage/snapshots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/footage/one_camera.h"
#include "core/footage/recording.h"

namespace vvr::footage {

namespace {

/// Seconds from the first of some times on, ascending. Of n equal times, each but the first is 1/n later.
std::vector<double> spread_times(const std::vector<Segment>& segments) {
    std::vector<double> times;
    for (auto next = segments.begin(); next != segments.end();) {
        const auto end =
            std::find_if(next, segments.end(), [&](const Segment& one) { return one.begin != next->begin; });
        const auto second = static_cast<double>(*next->begin - *segments.front().begin);
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

}  // namespace

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

}  // namespace vvr::footage
