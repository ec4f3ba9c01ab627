#include "core/dataset/manifest.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/base/version.h"
#include "core/fields/filter.h"
#include "core/fields/settings.h"

namespace vvr::dataset {
namespace {

constexpr const char* format_name = "vvr-extract";
constexpr int format_version = 2;
constexpr std::int64_t max_side = 65536;
constexpr std::int64_t max_count = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t latest_begin = 7'258'118'400;  // 2200-01-01

constexpr double max_time = 9.2e12;  // seconds: libav's range in microseconds

/// Reads the values of a JSON object by name, and checks their types and ranges.
class Reader {
  public:
    Reader(const Json& json, std::string name, std::string where = "")
        : json_(json), name_(std::move(name)), where_(std::move(where)) {
        if (!json.is_object())
            fail(fmt::format("'{}' is not an object", where_.empty() ? name_ : where_.substr(0, where_.size() - 1)));
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw Error(ErrorCode::file_invalid, fmt::format("'{}': {}; run `vvr extract` again", name_, what));
    }

    const Json& at(const char* key) const {
        const auto found = json_.find(key);
        if (found == json_.end()) fail(fmt::format("'{}{}' is missing", where_, key));
        return *found;
    }

    Reader object(const char* key) const { return {at(key), name_, fmt::format("{}{}.", where_, key)}; }

    std::int64_t integer(const char* key, std::int64_t low, std::int64_t high) const {
        const Json& value = at(key);
        if (!value.is_number_integer() || value < low || value > high) {
            fail(fmt::format("'{}{}' is {}, not an integer from {} to {}", where_, key, value.dump(), low, high));
        }
        return value.get<std::int64_t>();
    }

    double seconds(const char* key) const {
        const Json& value = at(key);
        if (!value.is_number() || !(value.get<double>() >= 0 && value.get<double>() <= max_time)) {
            fail(fmt::format("'{}{}' is {}, not a number from 0 to {}", where_, key, value.dump(), max_time));
        }
        return value.get<double>();
    }

    std::string text(const char* key) const {
        const Json& value = at(key);
        if (!value.is_string()) fail(fmt::format("'{}{}' is {}, not a string", where_, key, value.dump()));
        return value.get<std::string>();
    }

    bool has(const char* key) const { return json_.contains(key); }

    bool flag(const char* key) const {
        const Json& value = at(key);
        if (!value.is_boolean()) fail(fmt::format("'{}{}' is {}, not true or false", where_, key, value.dump()));
        return value.get<bool>();
    }

  private:
    const Json& json_;
    std::string name_;
    std::string where_;
};

Size read_size(const Reader& reader, const char* width, const char* height) {
    return {static_cast<int>(reader.integer(width, 1, max_side)),
            static_cast<int>(reader.integer(height, 1, max_side))};
}

media::VideoInfo read_clip(const Reader& reader) {
    media::VideoInfo info;
    if (reader.has("name")) info.title = reader.text("name");  // missing in older extractions
    info.container = reader.text("container");
    info.codec = reader.text("codec");
    info.size = read_size(reader, "width", "height");
    info.rate = reader.seconds("rate");
    info.duration = reader.seconds("seconds");
    info.frames = reader.integer("frames", 0, max_count);
    if (reader.has("began")) {
        info.began = reader.integer("began", 0, latest_begin);
        info.began_source = ClockSource::file_name;
    }
    return info;
}

Json json_of(const media::VideoInfo& clip) {
    Json json{{"name", clip.title},       {"container", clip.container}, {"codec", clip.codec},
              {"width", clip.size.width}, {"height", clip.size.height},  {"rate", clip.rate},
              {"seconds", clip.duration}, {"frames", clip.frames}};
    // No other source tells when it was recorded.
    if (clip.began && clip.began_source == ClockSource::file_name) json["began"] = *clip.began;
    return json;
}

Json json_of(const media::FrameSpan& span) {
    Json json{{"start", span.start}, {"first", span.first}};
    if (span.end) json["end"] = *span.end;
    if (span.stop) json["stop"] = *span.stop;
    return json;
}

media::FrameSpan read_span(const Reader& reader) {
    media::FrameSpan span;
    span.start = reader.seconds("start");
    span.first = reader.integer("first", 0, max_count);
    if (reader.has("end")) span.end = reader.seconds("end");
    if (reader.has("stop")) span.stop = reader.integer("stop", 0, max_count);
    return span;
}

StoredFrame read_frame(const Json& json, std::size_t number, const std::string& name) {
    const Reader reader(json, name, fmt::format("frames[{}].", number));
    StoredFrame frame;
    frame.index = reader.integer("index", 0, max_count);
    frame.pts = reader.seconds("pts");
    if (reader.has("seeds")) frame.seeds = reader.integer("seeds", 0, max_count);
    if (reader.has("view")) frame.view = reader.integer("view", 0, max_count);
    if (reader.has("before")) {
        const std::string before = reader.text("before");
        const auto row = std::ranges::find(condition::condition_rows, before, &condition::ConditionRow::name);
        if (row == condition::condition_rows.end())
            reader.fail(fmt::format("'before' is '{}', which is no condition", before));
        frame.before = row->kind;
    }
    if (reader.has("gap")) frame.gap = reader.integer("gap", 1, max_count);
    return frame;
}

std::vector<StoredFrame> read_frames(const Reader& reader, const std::string& name) {
    const Json& list = reader.at("frames");
    if (!list.is_array()) reader.fail("'frames' is not a list");
    if (list.empty())
        throw Error(ErrorCode::no_frame, fmt::format("'{}' lists no frames; run `vvr extract` again", name));
    std::vector<StoredFrame> frames;
    frames.reserve(list.size());
    for (const Json& entry : list) {
        const StoredFrame frame = read_frame(entry, frames.size(), name);
        if (!frames.empty() && frame.index != frames.back().index + frame.gap + 1) {
            reader.fail(fmt::format("frame {} follows frame {}", frame.index, frames.back().index));
        }
        if (!frames.empty() && frame.pts < frames.back().pts) {
            reader.fail(fmt::format("the time of frame {}, {} s, is before that of frame {}, {} s", frame.index,
                                    frame.pts, frames.back().index, frames.back().pts));
        }
        frames.push_back(frame);
    }
    return frames;
}

}  // namespace

namespace stored {

std::filesystem::path scalar_file(std::int64_t index) {
    return std::filesystem::path(scalar) / fmt::format("{:06}.png", index);
}
std::filesystem::path flow_file(std::int64_t index) {
    return std::filesystem::path(flow) / fmt::format("{:06}.flo", index);
}
std::filesystem::path colour_file(std::int64_t index) {
    return std::filesystem::path(colour) / fmt::format("{:06}.png", index);
}
std::filesystem::path view_file(std::int64_t view) {
    return std::filesystem::path(views) / fmt::format("{}.png", view);
}

std::filesystem::path seed_file(std::int64_t index) {
    return std::filesystem::path(seeds) / fmt::format("{:06}.txt", index);
}

}  // namespace stored

std::string format_manifest(const Manifest& manifest) {
    const Json head{{"format", format_name},
                    {"format_version", format_version},
                    {"complete", true},
                    {"vvr", version()},
                    {"clip", json_of(manifest.clip)},
                    {"span", json_of(manifest.span)},
                    {"field_width", manifest.field_size.width},
                    {"field_height", manifest.field_size.height},
                    {"flow_every", manifest.flow_every},
                    {"damaged", manifest.damaged},
                    {stored::colour, manifest.colour},
                    {"reference", manifest.reference},
                    {"views", manifest.views},
                    {"settings", object_of(manifest.settings)}};
    std::string text = json_text(head, 2);
    text.erase(text.rfind('\n'));  // the closing brace
    text += ",\n  \"frames\": [";
    // One line per frame, so that people can read and compare the list.
    for (const StoredFrame& frame : manifest.frames) {
        Json entry{{"index", frame.index}, {"pts", frame.pts}};
        if (frame.seeds) entry["seeds"] = *frame.seeds;
        if (frame.view > 0) entry["view"] = frame.view;
        if (frame.before != condition::Kind::no_signal) entry["before"] = row_of(frame.before).name;
        if (frame.gap > 0) entry["gap"] = frame.gap;
        text += (&frame == &manifest.frames.front() ? "\n    " : ",\n    ") + entry.dump();
    }
    return text + "\n  ]\n}\n";
}

std::string unfinished_manifest() {
    return Json{{"format", format_name}, {"format_version", format_version}, {"complete", false}}.dump(2) + "\n";
}

Manifest parse_manifest(std::string_view text, const std::string& name) {
    const Json json = parse_json(text);
    if (json.is_discarded()) {
        throw Error(ErrorCode::file_invalid, fmt::format("'{}' is not JSON; run `vvr extract` again", name));
    }
    const Reader reader(json, name);
    if (reader.text("format") != format_name) reader.fail(fmt::format("'format' is not '{}'", format_name));
    const std::int64_t found = reader.integer("format_version", 1, max_count);
    if (found != format_version) {
        reader.fail(fmt::format("'format_version' is {}, but this vvr reads {}", found, format_version));
    }
    if (!reader.flag("complete")) reader.fail("the extraction was not finished");

    Manifest manifest;
    manifest.clip = read_clip(reader.object("clip"));
    manifest.span = read_span(reader.object("span"));
    manifest.field_size = read_size(reader, "field_width", "field_height");
    manifest.flow_every = reader.integer("flow_every", 0, max_count);
    manifest.damaged = reader.integer("damaged", 0, max_count);
    manifest.colour = reader.flag(stored::colour);
    manifest.reference = reader.flag("reference");
    manifest.views = reader.integer("views", 0, max_count);
    const Reader settings = reader.object("settings");
    for (const auto& [option, value] : reader.at("settings").items()) {
        manifest.settings.emplace_back(option, settings.text(option.c_str()));
        const std::string& given = manifest.settings.back().second;
        if (option == setting::filter.name &&
            std::ranges::count(fields::filters(), given, &fields::FilterRow::name) == 0) {
            reader.fail(fmt::format("'settings.{}' is '{}', which this vvr does not know", option, given));
        }
    }
    manifest.frames = read_frames(reader, name);
    for (const StoredFrame& frame : manifest.frames) {
        if (frame.view > manifest.views)
            reader.fail(fmt::format("frame {} has view {}, but there are {}", frame.index, frame.view, manifest.views));
    }
    return manifest;
}

namespace {

/// A folder's manifest as JSON; empty if there is no such file.
std::optional<Json> manifest_of(const std::filesystem::path& folder) {
    std::error_code none;
    const std::filesystem::path file = folder / stored::manifest;
    if (!std::filesystem::is_regular_file(file, none)) return std::nullopt;
    return parse_json(read_file(file.string()));
}

bool is_ours(const Json& json) {
    return json.is_object() && json.contains("format") && json["format"] == format_name;
}

}  // namespace

bool is_data_folder(const std::filesystem::path& folder) {
    const std::optional<Json> json = manifest_of(folder);
    return json && (json->is_discarded() || is_ours(*json));
}

bool is_replaceable(const std::filesystem::path& folder) {
    const std::optional<Json> json = manifest_of(folder);
    return json && is_ours(*json);
}

bool has_complete_data(const std::filesystem::path& folder) {
    const std::optional<Json> json = manifest_of(folder);
    return json && is_ours(*json) && json->value("complete", Json()) != Json(false);
}

}  // namespace vvr::dataset
