#include "cli/write/report.h"

#include <optional>

#include <sys/resource.h>

#include <fmt/format.h>

#include "cli/excerpt/footage.h"
#include "cli/plan/settings.h"
#include "cli/plan/video_scale.h"
#include "core/annotation/time_ticks.h"
#include "core/base/digest.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/image/text.h"
#include "core/tracking/event.h"
#include "core/tracking/event_line.h"

namespace vvr::app {

namespace {

/// Increase it when readers of older reports would misread a new one.
constexpr int format_version = 1;

Json json_of(const Moment& moment) {
    return {{"frame", moment.frame}, {"seconds", rounded(moment.seconds)}};
}

/// A moment with its wall-clock time, and its file of the recording and the time in that file.
Json json_of(const Moment& moment, const MomentPlaces& places) {
    Json json = json_of(moment);
    json.update(places(moment.seconds));
    return json;
}

Json json_of(const volume::CompressedIdle& stretch) {
    return {{"first", rounded(stretch.begin)},
            {"seconds", rounded(stretch.seconds)},
            {"room", rounded(stretch.t_end - stretch.t_begin)}};
}

/// Adds the digest, which identifies the file under any name.
void add_digest(Json& json, const std::string& path) {
    const auto digest = digest_of(path);
    json["bytes"] = digest ? Json(digest->bytes) : Json();
    json["digest"] = digest ? Json(digest->ends) : Json();
}

Json json_of(const media::SegmentPlace& segment) {
    Json json{{"file", segment.path},
              {"first_frame", segment.first_frame},
              {"first", rounded(segment.begin)},
              {"end", rounded(segment.end)}};
    add_digest(json, segment.path);
    return json;
}

Json json_of(const glm::dvec2& place) {
    return {{"x", rounded(place.x)}, {"y", rounded(place.y)}};
}

Json json_of(const tracking::Stay& stay, const VideoScale& scale) {
    return {{"first", json_of(stay.first)},
            {"last", json_of(stay.last)},
            {"seconds", rounded(stay.last.seconds - stay.first.seconds)},
            {"place", json_of(scale(stay.place))},
            {"field_place", json_of(stay.place)},
            {"box", json_of_box(scale(stay.box))},
            {"field_box", json_of_box(stay.box)}};
}

Json json_of(const std::optional<tracking::Portrait>& portrait, const VideoScale& scale) {
    if (!portrait) return {};
    Json json = json_of(portrait->at);
    json["box"] = json_of_box(scale(portrait->box));
    json["field_box"] = json_of_box(portrait->box);
    return json;
}

Json json_of(const tracking::Evidence& evidence) {
    // Every region that differs has some thickness.
    const auto compared = [&](double value) { return evidence.thickness > 0 ? Json(rounded(value)) : Json(); };
    return {{"difference", compared(evidence.difference)},
            {"edges", compared(evidence.edges)},
            {"scene_edges", compared(evidence.scene_edges)},
            {"thickness", compared(evidence.thickness)},
            {"alone", rounded(evidence.alone)},
            {"moved", rounded(evidence.moved)},
            {"novelty", rounded(evidence.novelty)},
            {"flicker", rounded(evidence.flicker)},
            {"changed", rounded(evidence.changed)},
            {"carried", evidence.carried},
            {"confidence", rounded(evidence.confidence)},
            {"refuted", evidence.refuted ? Json(tracking::name_of(*evidence.refuted)) : Json()}};
}

Json json_of(const tracking::Signs& signs) {
    Json json = Json::object();
    for (std::size_t k = 0; k < signs.size(); ++k) json[std::string(tracking::sign_table[k].name)] = rounded(signs[k]);
    return json;
}

Json json_of(const tracking::Change& change, const VideoScale& scale) {
    return {{"first", json_of(change.first)},
            {"last", json_of(change.last)},
            {"box", json_of_box(scale(change.box))},
            {"field_box", json_of_box(change.box)},
            {"probability", rounded(tracking::probability_of(change.signs))},
            {"signs", json_of(change.signs)},
            {"evidence", json_of(change.evidence)}};
}

Json json_of(const ShownEvents& shown, std::size_t place, const VideoScale& scale, const MomentPlaces& where) {
    const tracking::Event& event = shown.events[place];
    const auto number_of = [&](const std::optional<std::size_t>& other) {
        return other ? Json(shown.numbers[*other]) : Json();
    };
    Json json{{"number", shown.numbers[place]},
              {"kind", tracking::name_of(event.kind)},
              {"class", Json()},
              {"group", Json()},
              {"score", Json()},
              {"looks", Json()},
              {"first", json_of(event.first, where)},
              {"last", json_of(event.last, where)},
              {"seconds", rounded(event.last.seconds - event.first.seconds)},
              {"open_ended", event.open_ended},
              {"from", number_of(event.from)},
              {"into", number_of(event.into)},
              {"by", number_of(event.by)},
              {"alone_since", event.alone_since ? json_of(*event.alone_since) : Json()},
              {"probability", rounded(tracking::probability_of(event.signs))},
              {"signs", json_of(event.signs)},
              {"evidence", event.evidence ? json_of(*event.evidence) : Json()},
              {"portrait", json_of(event.portrait, scale)},
              {"box", json_of_box(scale(event.box))},
              {"field_box", json_of_box(event.box)},
              {"direction", or_null(tracking::direction_of(event))},
              {"path_length", rounded(scale.length(event.path))},
              {"field_path_length", rounded(event.path_length)}};
    if (const auto& identity = event.identity) {
        json["class"] = identity->what->name;
        json["group"] = detector::name_of(identity->what->group);
        json["score"] = rounded(identity->score);
        json["looks"] = identity->looks;
    }
    json["path"] = list_of(event.path, [&](const tracking::PathPoint& point) {
        Json there = json_of(point.at);
        there["place"] = json_of(scale(point.place));
        there["field_place"] = json_of(point.place);
        return there;
    });
    json["stays"] = list_of(event.stays, [&](const tracking::Stay& stay) { return json_of(stay, scale); });
    return json;
}

Json json_of(const DetectorUse& use) {
    return {{"format", use.format},
            {"events", use.events},
            {"looks", use.looks},
            {"frames", use.frames},
            {"seconds", rounded(use.seconds)}};
}

Json json_of(const annotation::Label& label) {
    Json json = json_of_box(label.box);
    json["text"] = label.text;
    return json;
}

std::int64_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::int64_t{usage.ru_maxrss} * 1024;
}

/// The start of the clip (UTC) and the source of that time: the clip's name, even if the picture doesn't show it; else
/// the user's choice.
std::pair<std::optional<std::int64_t>, ClockSource> recorded_at(const media::VideoInfo& info, const WallClock& clock) {
    if (recording_time_is_known(info)) return {info.began, info.began_source};
    if (clock && clock->utc_offset) return {clock->begin - *clock->utc_offset, clock->source};
    return {std::nullopt, ClockSource::none};
}

/// The settings used, and the font if there is text: the system's default font if none was chosen.
image::Metadata settings_and_font(const RunContext& context) {
    image::Metadata settings = context.plan.output.settings;
    const annotation::Lettering& lettering = context.composed.lettering;
    const bool text = !lettering.labels.empty() || !lettering.badges.empty();
    if (text) image::put(settings, "font", image::font_name());
    return settings;
}

/// The classes of the objects by their numbers: "1 person, 4 car". Empty without a detector.
std::string classes_text(const Observation& seen) {
    std::string text;
    if (!seen.events) return text;
    for (std::size_t k = 0; k < seen.events->events.size(); ++k) {
        const auto& identity = seen.events->events[k].identity;
        if (!identity) continue;
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", seen.events->numbers[k], identity->what->name);
    }
    return text;
}

Json json_of_clip(const media::VideoInfo& info, const WallClock& clock, const std::string& camera) {
    const auto known = [](auto value) { return value > 0 ? Json(value) : Json(); };
    const auto [recorded, recorded_by] = recorded_at(info, clock);
    Json json{{"name", info.name},
              {"camera", or_null(camera)},
              {"container", info.container},
              {"codec", info.codec},
              {"width", info.size.width},
              {"height", info.size.height},
              {"rate", known(info.rate)},
              {"recorded", recorded ? Json(annotation::format_clock(*recorded)) : Json()},
              {"recorded_by", recorded ? Json(row_of(recorded_by).name) : Json()},
              {"written", info.created ? Json(annotation::format_clock(*info.created)) : Json()}};
    add_digest(json, info.segments.empty() ? info.name : std::string());
    return json;
}

Json json_of(const WallClock& clock, double first, double last) {
    if (!clock) return {};
    return {{"first", clock->iso(first)},
            {"last", clock->iso(last)},
            {"zone", or_null(clock->zone)},
            {"source", row_of(clock->source).name}};
}

}  // namespace

std::string format_report(const RunContext& context, const std::vector<std::string>& advice, double seconds,
                          const ArchiveFacts& archive) {
    const auto& [plan, seen, composed, run] = context;
    const media::VideoInfo& info = seen.info;
    const double first = seen.begin.seconds;
    const double last = seen.end().seconds;
    const Size field = plan.read.clip.field_size;
    const auto json_of_each = [](const auto& each) { return json_of(each); };
    Json json{
        {"report", format_version},
        {"vvr", version()},
        {"input", json_of_clip(info, plan.read.clock, plan.read.camera)},
        {"frames",
         {{"used", seen.summary.frames},
          {"damaged", seen.summary.damaged},
          {"decoded", info.decodes->name},
          {"hwaccel", info.hwaccel->name}}},
        {"span", {{"first", rounded(first)}, {"last", rounded(last)}, {"seconds", rounded(last - first)}}},
        {"field", {{"width", field.width}, {"height", field.height}}},
        {"volume",
         {{"layers", seen.volume.layers()},
          {"frames_per_layer", seen.volume.step()},
          {"bricks", composed.bricks.size()},
          {"arrows", composed.scene.arrows.size()},
          {"still", run.nothing_moves},
          {"compressed", list_of(composed.compressed_idle, json_of_each)}}},
    };
    json["clock"] = json_of(plan.read.clock, first, last);
    json["segments"] = info.segments.empty() ? Json() : list_of(info.segments, json_of_each);
    json["problems"] = plan.read.clip.warnings;
    for (const std::string& problem : seen.summary.problems) json["problems"].push_back(problem);
    json["left_out"] = {
        {"files", info.left_out.files}, {"frames", info.left_out.frames}, {"seconds", rounded(info.left_out.seconds)}};
    const MomentPlaces places{info.segments, plan.read.clock};
    json["unseen"] = json_of(unseen_of(plan, seen), [&](double at) {
        Json moment{{"seconds", rounded(at)}};
        moment.update(places(at));
        return moment;
    });
    json["settings"] = object_of(settings_and_font(context));
    json["renderer"] = run.renderer.empty()
                           ? Json()
                           : Json{{"name", run.renderer}, {"version", run.gl_version}, {"backend", run.backend}};
    json["labels"] = list_of(composed.lettering.labels, json_of_each);
    json["seconds"] = Json::object();
    for (const auto& [stage, took] : run.stages.seconds()) json["seconds"][stage] = rounded(took);
    json["seconds"]["total"] = rounded(seconds);
    json["peak_memory_bytes"] = peak_memory();
    json["advice"] = advice;
    json["detector"] = seen.detector ? json_of(*seen.detector) : Json();
    for (const char* key : {"events", "changes", "overlays"}) json[key] = Json();
    if (seen.events) {
        const VideoScale scale(field, info.size);
        json["events"] = Json::array();
        json["changes"] = list_of(seen.findings.changes, [&](const auto& change) { return json_of(change, scale); });
        json["overlays"] = list_of(seen.findings.overlays, [&](const PixelBox& box) {
            return Json{{"box", json_of_box(scale(box))}, {"field_box", json_of_box(box)}};
        });
        for (std::size_t k = 0; k < seen.events->events.size(); ++k)
            json["events"].push_back(json_of(*seen.events, k, scale, places));
    }
    for (const double tile : archive.tiles) json["stills"].push_back(rounded(tile));
    if (!archive.not_kept.empty()) json["not_kept"] = archive.not_kept;
    if (archive.not_kept_code) json["not_kept_code"] = row_of(*archive.not_kept_code).name;
    return json_text(json, 2) + "\n";
}

image::Metadata record_of(const RunContext& context) {
    const auto& [plan, seen, composed, run] = context;
    const volume::Volume& volume = seen.volume;
    image::Metadata record = settings_and_font(context);
    record.emplace_back("frames", fmt::to_string(volume.frames() - volume.missing()));
    if (plan.volume.series) {
        // The damage is only known at the end of the clip.
        record.emplace_back("first-frame", fmt::to_string(seen.begin.frame));
        record.emplace_back("seconds", fmt::format("{:.3f} to {:.3f}", seen.begin.seconds, seen.end().seconds));
    } else {
        record.emplace_back("damaged", fmt::to_string(seen.summary.damaged));
    }
    record.emplace_back("frames-per-layer", fmt::to_string(volume.step()));
    record.emplace_back("layers-drawn", fmt::to_string(volume.layers()));
    record.emplace_back("renderer", run.renderer);
    if (const std::string classes = classes_text(seen); !classes.empty()) record.emplace_back("classes", classes);
    return record;
}

}  // namespace vvr::app
