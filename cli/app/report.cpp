#include "cli/app/report.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <sys/resource.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/digest.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/events/event.h"
#include "core/labels/time_ticks.h"
#include "core/store/manifest.h"

namespace vvr::app {

namespace {

using Json = nlohmann::ordered_json;

/// Raised when a reader of older reports would misread one.
constexpr int format_version = 1;

/// From the field's pixels to those of the video.
class Scale {
  public:
    Scale(Size field, Size video)
        : video_(video),
          x_(static_cast<double>(video.width) / field.width),
          y_(static_cast<double>(video.height) / field.height) {}

    glm::dvec2 operator()(const glm::dvec2& place) const {
        return {(place.x + 0.5) * x_ - 0.5, (place.y + 0.5) * y_ - 0.5};
    }

    PixelBox operator()(const PixelBox& box) const {
        return {static_cast<int>(std::floor(box.left * x_)), static_cast<int>(std::floor(box.top * y_)),
                std::min(video_.width, static_cast<int>(std::ceil(box.right * x_))),
                std::min(video_.height, static_cast<int>(std::ceil(box.bottom * y_)))};
    }

    double length(const std::vector<events::PathPoint>& path) const {
        double length = 0;
        for (std::size_t k = 1; k < path.size(); ++k) {
            length += glm::distance((*this)(path[k - 1].place), (*this)(path[k].place));
        }
        return length;
    }

  private:
    Size video_;
    double x_;
    double y_;
};

/// Places and times are no better than this, and shorter to read.
double rounded(double value) {
    return std::round(value * 1000) / 1000;
}

Json json_of(const Moment& moment) {
    return {{"frame", moment.frame}, {"seconds", rounded(moment.seconds)}};
}

/// What tells where in the world a moment of the clip is.
struct Place {
    const std::vector<video::SegmentPlace>& segments;  ///< of a recording
    const WallClock& clock;
};

/// With the time of day, and the file of a recording in which it is and where in that file.
Json json_of(const Moment& moment, const Place& place) {
    Json json = json_of(moment);
    if (place.clock) json["time"] = place.clock->iso(moment.seconds);
    const auto after = std::ranges::upper_bound(place.segments, moment.frame, {}, &video::SegmentPlace::first_frame);
    if (after == place.segments.begin()) return json;
    const video::SegmentPlace& segment = *std::prev(after);
    json["file"] = segment.path;
    json["offset"] = rounded(std::max(0.0, moment.seconds - segment.begin));
    return json;
}

Json json_of(const std::vector<bricks::CompressedIdle>& squeezed) {
    Json json = Json::array();
    for (const bricks::CompressedIdle& stretch : squeezed) {
        json.push_back({{"first", rounded(stretch.begin)},
                        {"seconds", rounded(stretch.seconds)},
                        {"room", rounded(stretch.t_end - stretch.t_begin)}});
    }
    return json;
}

/// By which a file is known again, whatever it is called then.
void add_digest(Json& json, const std::string& path) {
    const auto digest = digest_of(path);
    json["bytes"] = digest ? Json(digest->bytes) : Json();
    json["digest"] = digest ? Json(digest->ends) : Json();
}

Json json_of(const video::SegmentPlace& segment) {
    Json json{{"file", segment.path},
              {"first_frame", segment.first_frame},
              {"first", rounded(segment.begin)},
              {"end", rounded(segment.end)}};
    add_digest(json, segment.path);
    return json;
}

Json json_of(const PixelBox& box) {
    return {{"x", box.left}, {"y", box.top}, {"width", box.width()}, {"height", box.height()}};
}

Json json_of(const glm::dvec2& place) {
    return {{"x", rounded(place.x)}, {"y", rounded(place.y)}};
}

Json json_of(const events::Stay& stay, const Scale& scale) {
    return {{"first", json_of(stay.first)},
            {"last", json_of(stay.last)},
            {"seconds", rounded(stay.last.seconds - stay.first.seconds)},
            {"place", json_of(scale(stay.place))},
            {"field_place", json_of(stay.place)},
            {"box", json_of(scale(stay.box))},
            {"field_box", json_of(stay.box)}};
}

Json number_of(const std::optional<std::size_t>& place) {
    return place ? Json(*place + 1) : Json();
}

Json json_of(const std::optional<events::Portrait>& portrait, const Scale& scale) {
    if (!portrait) return {};
    Json json = json_of(portrait->at);
    json["box"] = json_of(scale(portrait->box));
    json["field_box"] = json_of(portrait->box);
    return json;
}

Json json_of(const events::Event& event, std::size_t place, const Scale& scale, const Place& where) {
    Json json{{"number", place + 1},
              {"kind", events::name_of(event.kind)},
              {"first", json_of(event.first, where)},
              {"last", json_of(event.last, where)},
              {"seconds", rounded(event.last.seconds - event.first.seconds)},
              {"from", number_of(event.from)},
              {"into", number_of(event.into)},
              {"by", number_of(event.by)},
              {"alone_since", event.alone_since ? json_of(*event.alone_since) : Json()},
              {"portrait", json_of(event.portrait, scale)},
              {"box", json_of(scale(event.box))},
              {"field_box", json_of(event.box)},
              {"path_length", rounded(scale.length(event.path))},
              {"field_path_length", rounded(event.path_length)}};
    json["path"] = Json::array();
    for (const events::PathPoint& point : event.path) {
        Json there = json_of(point.at);
        there["place"] = json_of(scale(point.place));
        there["field_place"] = json_of(point.place);
        json["path"].push_back(std::move(there));
    }
    json["stays"] = Json::array();
    for (const events::Stay& stay : event.stays) json["stays"].push_back(json_of(stay, scale));
    return json;
}

Json json_of(const labels::Label& label) {
    Json json = json_of(label.box);
    json["text"] = label.text;
    return json;
}

std::int64_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::int64_t{usage.ru_maxrss} * 1024;
}

double length_of(const events::Event& event) {
    return event.last.seconds - event.first.seconds;
}

/// When the clip began (UTC), and what tells that: its name, whether the picture shows it or not, else what the user
/// chose.
std::pair<std::optional<std::int64_t>, ClockSource> recorded_at(const RenderReport& report) {
    const video::VideoInfo& info = report.info;
    if (recording_time_is_known(info)) return {info.began, info.began_source};
    const WallClock& clock = report.clock;
    if (clock && clock->utc_offset) return {clock->begin - *clock->utc_offset, clock->source};
    return {std::nullopt, ClockSource::none};
}

}  // namespace

std::string format_report(const RenderReport& report, const image::Metadata& settings, double seconds) {
    const video::VideoInfo& info = report.info;
    const auto known = [](auto value) { return value > 0 ? Json(value) : Json(); };
    const auto [recorded, recorded_by] = recorded_at(report);
    Json json{
        {"report", format_version},
        {"vvr", version()},
        {"input",
         {{"name", info.name},
          {"container", info.container},
          {"codec", info.codec},
          {"width", info.size.width},
          {"height", info.size.height},
          {"rate", known(info.rate)},
          {"recorded", recorded ? Json(labels::format_clock(*recorded)) : Json()},
          {"recorded_by", recorded ? Json(row_of(recorded_by).name) : Json()},
          {"written", info.created ? Json(labels::format_clock(*info.created)) : Json()}}},
        {"frames", {{"used", report.frames}, {"damaged", report.damaged}}},
        {"span",
         {{"first", rounded(report.first_pts)},
          {"last", rounded(report.last_pts)},
          {"seconds", rounded(report.last_pts - report.first_pts)}}},
        {"field", {{"width", report.field_size.width}, {"height", report.field_size.height}}},
        {"volume",
         {{"layers", report.layers},
          {"frames_per_layer", report.step},
          {"bricks", report.bricks.size()},
          {"arrows", report.arrows},
          {"still", report.still},
          {"squeezed", json_of(report.squeezed)}}},
    };
    add_digest(json["input"], info.segments.empty() ? info.name : std::string());
    json["clock"] = Json();
    if (report.clock) {
        const std::string& zone = report.clock->zone;
        json["clock"] = {{"first", report.clock->iso(report.first_pts)},
                         {"last", report.clock->iso(report.last_pts)},
                         {"zone", zone.empty() ? Json() : Json(zone)},
                         {"source", row_of(report.clock->source).name}};
    }
    json["segments"] = Json();
    if (!info.segments.empty()) {
        json["segments"] = Json::array();
        for (const video::SegmentPlace& segment : info.segments) json["segments"].push_back(json_of(segment));
    }
    json["problems"] = report.problems;
    json["left_out"] = {
        {"files", info.left_out.files}, {"frames", info.left_out.frames}, {"seconds", rounded(info.left_out.seconds)}};
    json["settings"] = Json::object();
    for (const auto& [name, value] : settings) json["settings"][name] = value;
    json["renderer"] = {{"name", report.renderer}, {"version", report.gl_version}, {"backend", report.backend}};
    json["labels"] = Json::array();
    for (const labels::Label& label : report.lettering.labels) json["labels"].push_back(json_of(label));
    json["seconds"] = Json::object();
    for (const auto& [stage, took] : report.stages.seconds()) json["seconds"][stage] = rounded(took);
    json["seconds"]["total"] = rounded(seconds);
    json["peak_memory_bytes"] = peak_memory();
    json["advice"] = report.advice;
    json["events"] = Json();
    if (report.events) {
        json["events"] = Json::array();
        const Scale scale(report.field_size, info.size);
        for (std::size_t k = 0; k < report.events->size(); ++k) {
            json["events"].push_back(json_of((*report.events)[k], k, scale, {info.segments, report.clock}));
        }
    }
    return json_text(json, 2) + "\n";
}

std::string summary_of(const std::vector<events::Event>& events, const WallClock& clock) {
    if (events.empty()) return "no events";
    const auto longest = std::ranges::max_element(events, {}, length_of);
    const double first = longest->first.seconds;
    const double last = longest->last.seconds;
    std::string text = fmt::format(
        "{}; the longest from {}", counted(std::ssize(events), "event"),
        clock ? labels::format_interval(first, last, clock) : fmt::format("{:.1f} s to {:.1f} s", first, last));
    const double still = events::stationary_seconds(*longest);
    if (still > 0) text += fmt::format(", standing still for {:.1f} s", still);
    return text;
}

namespace {

/// Where the events are mostly pieces of one part of the scene.
std::optional<std::string> advice_on_clutter(const RenderJob& job, const RenderReport& report) {
    // Who names a region knows the option; what was extracted takes none.
    if (!report.events || !job.fields.roi.empty() || store::is_data_folder(job.input.names.front()))
        return std::nullopt;
    const std::optional<events::Clutter> scraps = events::find_clutter(*report.events, report.field_size);
    if (!scraps) return std::nullopt;
    const double x = static_cast<double>(report.info.size.width) / report.field_size.width;
    const double y = static_cast<double>(report.info.size.height) / report.field_size.height;
    const PixelBox& box = scraps->box;
    return fmt::format(
        "'{}': {} of {} events are small and keep to one place, most of them in {:.0f}x{:.0f} pixels at {:.0f},{:.0f}; "
        "if they tell you nothing, choose where to look with --roi; this makes a page to draw it on: vvr inspect '{}' "
        "--frame {:.1f}s -o roi.html",
        report.info.name, scraps->count, report.events->size(), box.width() * x, box.height() * y, box.left * x,
        box.top * y, report.info.name, scraps->at.seconds);
}

}  // namespace

std::vector<std::string> advice_on(const RenderJob& job, const RenderReport& report) {
    std::vector<std::string> advice;
    if (auto text = advice_on_clutter(job, report)) advice.push_back(std::move(*text));
    return advice;
}

}  // namespace vvr::app
