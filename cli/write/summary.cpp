#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/plan/input.h"
#include "cli/write/report.h"
#include "core/annotation/time_ticks.h"
#include "core/base/text.h"
#include "core/dataset/manifest.h"
#include "core/fields/region.h"
#include "core/tracking/event.h"

namespace vvr::app {

namespace {

double length_of(const tracking::Event& event) {
    return event.last.seconds - event.first.seconds;
}

/// A suggestion if most events are fragments in one part of the scene.
std::optional<std::string> advice_on_clutter(const Plan& plan, const Observation& seen) {
    // A user who gives a region knows the option; an extraction doesn't accept one.
    if (!seen.events || plan.field.has_roi || dataset::is_data_folder(plan.read.input.names.front()))
        return std::nullopt;
    const std::vector<tracking::Event>& events = seen.events->events;
    const Size field = plan.read.clip.field_size;
    const std::optional<tracking::Clutter> scraps = tracking::find_clutter(events, field);
    if (!scraps) return std::nullopt;
    const double x = static_cast<double>(seen.info.size.width) / field.width;
    const double y = static_cast<double>(seen.info.size.height) / field.height;
    const PixelBox& box = scraps->box;
    return fmt::format(
        "'{}': {} of {} events are small and stay in one place, most of them within {:.0f}x{:.0f} pixels at "
        "{:.0f},{:.0f}; if they are irrelevant, choose a region with --roi; this page helps to draw it: vvr inspect "
        "'{}' --frame {:.1f}s -o roi.html",
        seen.info.name, scraps->count, events.size(), box.width() * x, box.height() * y, box.left * x, box.top * y,
        seen.info.name, scraps->at.seconds);
}

/// A note if there are too few frames per second to see how a thing was put down.
std::optional<std::string> advice_on_rate(const Observation& seen) {
    constexpr double enough = 4.5;  // frames per second; with 5, a bag was found as with 30, with 2 it was not
    const double rate = seen.info.rate;
    if (!seen.events || rate <= 0 || rate >= enough) return std::nullopt;
    const bool all = seen.info.decoded_share == 1;
    const std::string found = all ? fmt::format("'{}' has {:.3g} frames per second", seen.info.name, rate)
                                  : fmt::format("{:.3g} frames per second of '{}' were decoded", rate, seen.info.name);
    return fmt::format("{}; with fewer than 5, vvr may miss things that were left behind or taken{}", found,
                       all ? "" : "; use --decode all");
}

/// The longest time in which the recording itself was at fault, and why.
std::optional<std::string> advice_on_recording(const Plan& plan, const Observation& seen) {
    const footage::Unseen unseen = unseen_of(plan, seen);
    const condition::Interval* worst = nullptr;
    for (const condition::Interval& interval : unseen.intervals) {
        if (row_of(interval.kind).cause.empty()) continue;
        if (worst == nullptr || interval.end - interval.begin > worst->end - worst->begin) worst = &interval;
    }
    if (worst == nullptr) return std::nullopt;
    const condition::ConditionRow& row = row_of(worst->kind);
    const std::string begin = annotation::format_moment(worst->begin, plan.read.clock);
    const std::string end = annotation::format_moment(worst->end, plan.read.clock);
    return fmt::format("'{}': {} {}; probably {}; look at the footage of that time yourself", seen.info.name, row.words,
                       begin == end ? "at " + begin : fmt::format("from {} to {}", begin, end), row.cause);
}

/// Why no time is compressed in a long clip.
std::optional<std::string> advice_on_time(const Plan& plan, const Observation& seen) {
    constexpr double is_long = 600;  // seconds
    const double missing = static_cast<double>(seen.volume.missing()) / static_cast<double>(seen.volume.frames());
    const double all = (1 - missing) * (seen.end().seconds - seen.begin.seconds);
    if (!plan.volume.nonuniform || all <= is_long || !volume::compressed_stretches(seen.volume).empty())
        return std::nullopt;
    const std::string found = !seen.events ? fmt::format("the filter {} finds no objects", plan.field.filter->name)
                              : seen.events->events.empty() ? "vvr found no event"
                                                            : "objects move nearly all the time";
    return fmt::format("'{}': none of the {} is compressed, because {}; --start and --end, or --roi, show a part of it",
                       seen.info.name, annotation::format_duration(all), found);
}

/// The classes of the events, the most frequent first: " (3 person, 1 car)". Empty without a detector.
std::string classes_of(const std::vector<tracking::Event>& events) {
    std::map<std::string_view, std::int64_t> counts;
    for (const tracking::Event& event : events) {
        if (event.identity) ++counts[event.identity->what->name];
    }
    std::vector<std::pair<std::string_view, std::int64_t>> sorted(counts.begin(), counts.end());
    std::ranges::stable_sort(sorted, std::greater(), &std::pair<std::string_view, std::int64_t>::second);
    std::string text;
    for (const auto& [name, count] : sorted) text += fmt::format("{}{} {}", text.empty() ? " (" : ", ", count, name);
    return text.empty() ? text : text + ")";
}

/// What was decoded: " (decoded: reference, 77 %)". Empty if all frames were. The share is that of the first file.
std::string decoded_text(const media::VideoInfo& info) {
    if (&*info.decodes == &media::frame_choices().front()) return "";
    if (info.segments.size() > 1) return fmt::format(" (decoded: {})", info.decodes->name);
    return fmt::format(" (decoded: {}, {:.0f} %)", info.decodes->name, 100 * info.decoded_share);
}

}  // namespace

std::string result_text(const RunContext& context) {
    const auto& [plan, seen, composed, run] = context;
    const std::filesystem::path& path = plan.output.files.path;
    const std::string name = path.empty() ? seen.info.name : path.string();
    const std::string frames = counted(seen.summary.frames, "frame") + decoded_text(seen.info);
    if (plan.volume.series) return fmt::format("'{}': {} of {}", name, counted(run.pictures, "picture"), frames);
    return fmt::format("'{}': {} in {} and {}", name, frames, counted(seen.volume.layers(), "layer"),
                       counted(std::ssize(composed.bricks), "brick"));
}

std::string events_summary(const std::vector<tracking::Event>& events, std::size_t not_chosen, const WallClock& clock) {
    if (events.empty() && not_chosen > 0)
        return fmt::format("no event that --events chooses, of {}",
                           counted(static_cast<std::int64_t>(not_chosen), "event"));
    if (events.empty()) return "no events";
    const auto longest = std::ranges::max_element(events, {}, length_of);
    const double first = longest->first.seconds;
    const double last = longest->last.seconds;
    std::string text = fmt::format(
        "{}{}; the longest from {}", counted(std::ssize(events), "event"), classes_of(events),
        clock ? annotation::format_interval(first, last, clock) : fmt::format("{:.1f} s to {:.1f} s", first, last));
    const tracking::EventKindRow& row = row_of(longest->kind);
    if (row.is_thing) text += fmt::format(", {}", row.words);
    if (row.tally == tracking::Tally::still)
        text += fmt::format(", {} {}{}", row.words, annotation::format_duration(tracking::stationary_seconds(*longest)),
                            longest->stays.size() > 1 ? " in all" : "");
    return text;
}

std::vector<std::string> advice_on(const Plan& plan, const Observation& seen) {
    std::vector<std::string> advice;
    if (auto text = advice_on_recording(plan, seen)) advice.push_back(std::move(*text));
    if (auto text = advice_on_clutter(plan, seen)) advice.push_back(std::move(*text));
    if (auto text = advice_on_time(plan, seen)) advice.push_back(std::move(*text));
    if (auto text = advice_on_rate(seen)) advice.push_back(std::move(*text));
    return advice;
}

void log_warnings(const RunContext& context, const std::vector<std::string>& advice, Observer& observer) {
    const auto& [plan, seen, composed, run] = context;
    const std::string& name = seen.info.name;
    const Size field = plan.read.clip.field_size;
    const fields::FieldSummary& summary = seen.summary;
    report_warnings(plan.read.clip.warnings, summary.problems, observer);
    observer.debug(fmt::format("backend {}: {}", run.backend, run.renderer));
    observer.debug(fmt::format("fields {}x{}, {} arrows", field.width, field.height, composed.scene.arrows.size()));
    if (summary.damaged > 0) {
        observer.warn(fmt::format("'{}': {}; the picture shows the {} that could be decoded", name,
                                  counted(summary.damaged, "damaged packet"), counted(summary.frames, "frame")));
    }
    if (run.frames_missing) {
        observer.warn(fmt::format(
            "'{}' stores only the first and the last picture of the clip, so no other frames are shown", name));
    }
    if (!plan.volume.series && std::ssize(seen.keyframes) < plan.volume.keyframes) {
        observer.warn(fmt::format(
            "'{}': only {} of {} are shown, because the clip has no frames where the others should be, or its "
            "header states no length, or too great a length",
            name, seen.keyframes.size(), counted(plan.volume.keyframes, "key frame")));
    }
    if (composed.lettering.font_missing) {
        observer.warn("fontconfig found no font, so the picture has no text; install one, such as fonts-dejavu-core");
    } else if (const auto missing = composed.lettering.missing_characters(); !missing.empty()) {
        observer.warn(fmt::format("no font has {} of the picture's text: {}; install a font for them",
                                  counted(std::ssize(missing), "character"),
                                  shown_text(fmt::format("{}", fmt::join(missing, " ")))));
    }
    if (run.nothing_moves && summary.frames < 2) {
        observer.warn(fmt::format("'{}' has only one frame, so nothing can move and the volume is empty", name));
    } else if (run.nothing_moves && plan.field.has_region) {
        observer.warn(
            fmt::format("'{}': nothing moves in the region of interest, so the volume is empty; a larger region, "
                        "or a lower threshold, may show more",
                        name),
            {"roi", "mask", "threshold"});
    } else if (run.nothing_moves) {
        observer.warn(fmt::format("'{}': nothing moves, so the volume is empty; a lower threshold may show more", name),
                      {"threshold"});
    }
    for (const std::string& text : advice) observer.warn(text);
    if (!composed.compressed_idle.empty()) {
        double idle = 0;
        for (const volume::CompressedIdle& stretch : composed.compressed_idle) idle += stretch.seconds;
        observer.info(fmt::format("{} without motion are compressed on the time axis, in {}",
                                  annotation::format_duration(idle),
                                  counted(std::ssize(composed.compressed_idle), "place")));
    } else if (seen.volume.step() > 1 && !seen.volume.is_nonuniform()) {
        observer.info(fmt::format("each layer merges {} (--layers, --step)", counted(seen.volume.step(), "frame")));
    }
}

}  // namespace vvr::app
