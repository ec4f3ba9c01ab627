#include "cli/excerpt/footage.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/plan/input.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/dataset/manifest.h"
#include "core/footage/input_files.h"
#include "core/footage/segments.h"
#include "core/media/input.h"
#include "core/media/packet_copy.h"

namespace vvr::app {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& report, const std::string& what) {
    throw Error(ErrorCode::input_unsuitable,
                fmt::format("report '{}' {}; create a report with: vvr render CLIP --report report.json",
                            report.string(), what),
                {"report"});
}

ReportedFile file_of(const Json& json, const std::string& path, double begin, double end) {
    return {{path, begin, end, 0}, {json.at("bytes").get<std::int64_t>(), json.at("digest").get<std::string>()}};
}

/// The files with known size and digest; streams and pictures have none.
std::vector<ReportedFile> files_of(const Json& report) {
    std::vector<ReportedFile> files;
    const auto is_known = [](const Json& json) { return json.contains("digest") && json["digest"].is_string(); };
    const Json& input = report.at("input");
    constexpr double endless = std::numeric_limits<double>::infinity();
    if (is_known(input)) files.push_back(file_of(input, input.at("name").get<std::string>(), 0, endless));
    if (!report.contains("segments") || !report["segments"].is_array()) return files;
    for (const Json& segment : report["segments"]) {
        if (!is_known(segment)) continue;
        files.push_back(file_of(segment, segment.at("file").get<std::string>(), segment.at("first").get<double>(),
                                segment.at("end").get<double>()));
    }
    return files;
}

}  // namespace

namespace {

/// When a frame shows an event best: what was taken, just before it went.
/// \param portrait seconds; none = unknown
std::optional<double> best_moment(const std::string& kind, double first, std::optional<double> portrait) {
    constexpr double before = 1;  // seconds
    const auto row = std::ranges::find(tracking::event_kinds, kind, &tracking::EventKindRow::name);
    const bool is_of_scene = row != tracking::event_kinds.end() && row->is_of_scene;
    return is_of_scene ? std::max(0.0, first - before) : portrait;
}

}  // namespace

Json MomentPlaces::operator()(double seconds) const {
    Json json = Json::object();
    if (clock) json["time"] = clock->iso(seconds);
    if (const auto [file, offset] = footage::file_at(files, seconds); file != nullptr) {
        json["file"] = file->path;
        json["offset"] = rounded(offset);
    }
    return json;
}

PieceEvent piece_event(const tracking::Event& event, std::int64_t number, const VideoScale& scale) {
    PieceEvent found{number, event.first.seconds, event.last.seconds, std::string(tracking::name_of(event.kind))};
    if (event.identity) found.what = event.identity->what->name;
    const auto portrait = event.portrait ? std::optional(event.portrait->at.seconds) : std::nullopt;
    found.best = best_moment(found.kind, found.first, portrait);
    found.box = scale(event.box);
    found.best_box = event.portrait ? scale(event.portrait->box) : found.box;
    return found;
}

media::FrameSpan span_around(double first, double last, double margin) {
    // A span's end is exclusive, but the last frame is part of it.
    media::FrameSpan span;
    span.start = rounded(std::max(0.0, first - margin));
    span.end = rounded(last + margin) + media::shortest_frame;
    return span;
}

namespace {

std::optional<PixelBox> box_of(const Json& json) {
    const auto box = json.find("box");
    if (box == json.end() || !box->is_object()) return std::nullopt;
    const auto side = [&](const char* key) { return box->at(key).get<int>(); };
    return PixelBox{side("x"), side("y"), side("x") + side("width"), side("y") + side("height")};
}

/// An event of a report. Older reports have neither classes nor portraits.
PieceEvent event_of(const Json& json) {
    PieceEvent event{json.at("number").get<std::int64_t>(), json.at("first").at("seconds").get<double>(),
                     json.at("last").at("seconds").get<double>(), json.value("kind", "")};
    const auto what = json.find("class");
    if (what != json.end() && what->is_string()) event.what = what->get<std::string>();
    const Json portrait = json.value("portrait", Json());
    event.best = best_moment(event.kind, event.first,
                             portrait.is_object() ? std::optional(portrait.at("seconds").get<double>()) : std::nullopt);
    event.box = box_of(json);
    event.best_box = portrait.is_object() ? box_of(portrait) : event.box;
    return event;
}

/// The settings of a report, as text.
image::Metadata settings_of(const Json& report) {
    image::Metadata settings;
    const auto found = report.find("settings");
    if (found == report.end() || !found->is_object()) return settings;
    for (const auto& [name, value] : found->items()) {
        settings.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
    }
    return settings;
}

}  // namespace

ReportedEvents read_events(const std::filesystem::path& report) {
    const Json json = parse_json(read_file(report.string()));
    if (!json.is_object() || !json.contains("report") || !json.contains("events")) {
        refuse(report, "is not a report of `vvr render`");
    }
    if (!json["events"].is_array()) refuse(report, "has no list of events, because that run did not search for any");
    try {
        ReportedEvents events{files_of(json), {}, settings_of(json)};
        events.unseen = footage::unseen_areas_from(json.value("unseen", Json()));
        for (const Json& event : json["events"]) events.events.push_back(event_of(event));
        if (const Json camera = json.at("input").value("camera", Json()); camera.is_string()) events.camera = camera;
        if (events.files.empty())
            refuse(
                report,
                "lacks the sizes and digests of its files, because an older vvr wrote it or its input was not a file");
        return events;
    } catch (const Json::exception&) {
        refuse(report, "is not in the format of `vvr render`");
    }
}

namespace {

namespace fs = std::filesystem;

/// Refuses anything but a file with time stamps.
void check_single(const std::string& name) {
    const auto refuse = [&](const std::string& what) {
        throw Error(ErrorCode::input_unsuitable,
                    fmt::format("cannot cut '{}', which is {}; name video files, or a folder of them", name, what));
    };
    std::error_code none;
    if (name == "-") refuse("stdin and not a file");
    if (dataset::is_data_folder(name)) refuse("a folder of `vvr extract` without the video");
    if (fs::is_regular_file(name, none)) return;
    const auto is_picture = [](const auto& entry) {
        return footage::is_picture_name(entry.path().filename().string());
    };
    const fs::directory_iterator folder(name, none);
    if (!none && std::ranges::none_of(folder, is_picture)) refuse("a folder without video files");
    if (footage::list_pictures(name)) refuse("a sequence of pictures, not a video");
    if (media::is_url(name)) refuse("a URL and not yet a file");
    if (fs::exists(name, none)) refuse("not a regular file");
    media::open_file(name);  // throws if it can't be read
}

bool lies_in(const media::SegmentPlace& file, double first, double last) {
    return file.begin < last + media::time_tolerance && file.end > first + media::time_tolerance;
}

/// The name of the given file with the same content as a file of the report.
std::optional<std::string> find_by_digest(const Footage& footage, const ReportedFile& reported) {
    std::vector<std::string> candidates;
    for (const footage::Segment& file : footage.recording.segments) {
        std::error_code none;
        const std::uintmax_t size = fs::file_size(file.path, none);
        if (!none && std::cmp_equal(size, reported.digest.bytes)) candidates.push_back(file.path);
    }
    const fs::path name = fs::path(reported.place.path).filename();
    std::stable_partition(candidates.begin(), candidates.end(),
                          [&](const fs::path& path) { return path.filename() == name; });
    const auto found =
        std::ranges::find_if(candidates, [&](const std::string& path) { return digest_of(path) == reported.digest; });
    return found == candidates.end() ? std::nullopt : std::optional(*found);
}

[[noreturn]] void refuse_report(const std::string& report, std::int64_t event, const std::vector<std::string>& needed,
                                const std::vector<std::string>& missing, const Footage& footage) {
    const bool is_one = needed.size() == 1;
    throw Error(ErrorCode::input_unsuitable,
                fmt::format("event {} of report '{}' is in '{}'; by size and digest, {} not part of the input '{}'; "
                            "give {}, or a report about this input",
                            event, report, fmt::join(needed, "', '"),
                            is_one ? "that file is" : fmt::format("'{}' is", fmt::join(missing, "', '")),
                            footage.recording.name, is_one ? "that file" : "all of these files"),
                {"report"});
}

}  // namespace

Footage find_footage(const InputOptions& options) {
    require_input(options);
    const footage::RecorderNames layouts(options.name_patterns);
    if (options.names.size() == 1 && dataset::is_data_folder(options.names.front()))
        check_single(options.names.front());
    if (auto recording = footage::find_recording(options.names, layouts, options.join, options.rate))
        return {std::move(*recording), false};
    const std::string& name = options.names.front();
    check_single(name);
    const footage::Segment file = footage::segment_from_name(name, layouts);
    return {{name, file.camera, {file}, {}, options.rate}, true};
}

std::vector<media::SegmentPlace> place_by_packets(const Footage& footage, std::optional<double> until,
                                                  Observer& observer) {
    const std::vector<footage::Segment>& files = footage.recording.segments;
    if (footage.is_single) return {{files.front().path, 0, std::numeric_limits<double>::infinity(), 0}};
    std::vector<media::SegmentPlace> places;
    std::vector<std::string> problems;
    std::optional<std::int64_t> origin;
    std::optional<double> end;
    for (const footage::Segment& file : files) {
        try {
            if (!end) origin = file.begin;
            const double begin = footage::begin_of(file, origin, end).time;
            if (until && begin > *until) {
                places.push_back({file.path, begin, begin, 0});
                break;
            }
            end = std::max(end.value_or(0),
                           begin + media::length_of(media::open_input(file.path), footage.recording.rate));
            places.push_back({file.path, begin, *end, 0});
        } catch (const Error& error) {
            // A render of the recording skips files that are not video, so skip their times too. But a file that can't
            // be read now may have been read by the render; without it, times would be wrong.
            if (error.kind() != ErrorKind::not_video) throw;
            problems.emplace_back(error.what());
        }
    }
    if (places.empty()) throw Error(ErrorCode::not_video, problems.front());
    report_warnings(footage.recording.warnings, problems, observer);
    return places;
}

std::vector<media::SegmentPlace> place_by_report(const Footage& footage, const ReportedEvents& report,
                                                 const PieceEvent& event, double margin,
                                                 const std::string& report_name) {
    std::vector<media::SegmentPlace> places;
    std::vector<std::string> needed;
    std::vector<std::string> missing;
    for (const ReportedFile& file : report.files) {
        const bool is_needed = lies_in(file.place, event.first, event.last);
        if (is_needed) needed.push_back(file.place.path);
        if (!is_needed && !lies_in(file.place, event.first - margin, event.last + margin)) continue;
        if (const auto found = find_by_digest(footage, file)) {
            places.push_back(file.place);
            places.back().path = *found;
        } else if (is_needed) {
            missing.push_back(file.place.path);
        }
    }
    if (!missing.empty()) refuse_report(report_name, event.number, needed, missing, footage);
    return places;
}

std::vector<ExcerptFile> parts_in(const std::vector<media::SegmentPlace>& places, const media::FrameSpan& span) {
    std::vector<ExcerptFile> parts;
    double shown = 0;  // end of the previous files, in seconds of the recording
    for (const media::SegmentPlace& file : places) {
        const double from = std::max(span.start, shown);
        const bool overlaps = shown > std::max(file.begin, span.start) + media::time_tolerance;
        shown = std::max(shown, file.end);
        if (file.end <= from + media::time_tolerance) continue;
        if (span.end && file.begin >= *span.end - media::time_tolerance) break;
        ExcerptFile part{file, span, overlaps};
        part.span.start = std::max(0.0, from - file.begin);
        // The end of the span, not of the file: the file goes on after file.end if a search ended there.
        if (span.end) part.span.end = *span.end - file.begin;
        parts.push_back(part);
    }
    return parts;
}

}  // namespace vvr::app
