#include "core/page/page.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <string_view>
#include <unordered_map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/base/wall_clock.h"
#include "core/events/path.h"
#include "core/image/picture_file.h"
#include "core/labels/time_ticks.h"
#include "core/page/html.h"
#include "core/space/layout.h"
#include "web_files.h"

namespace vvr::page {

namespace {

constexpr std::array<std::string_view, 7> weekdays{"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
constexpr std::array<std::string_view, 12> months{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                  "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};

/// A wall-clock time, truncated to the minute.
struct Minute {
    std::chrono::sys_days day;
    std::string time;

    explicit Minute(double seconds) {
        const std::chrono::sys_seconds whole{std::chrono::seconds(std::llround(std::floor(seconds + 1e-4)))};
        day = std::chrono::floor<std::chrono::days>(whole);
        const auto minutes = std::chrono::duration_cast<std::chrono::minutes>(whole - day).count();
        time = fmt::format("{:02}:{:02}", minutes / 60, minutes % 60);
    }

    std::string date() const {
        const std::chrono::year_month_day date(day);
        return fmt::format("{} {} {} {}", weekdays.at(std::chrono::weekday(day).c_encoding()),
                           static_cast<unsigned>(date.day()), months.at(static_cast<unsigned>(date.month()) - 1),
                           static_cast<int>(date.year()));
    }
};

/// The heading: "back-door · Tue 17 Nov 2026, 07:15", with the end if it is in another minute. Without a clock, only
/// the name.
/// \param name name of the camera, or of the clip if the camera is unknown
/// \param begin, end seconds of the clip
std::string heading_of(const std::string& name, const WallClock& clock, double begin, double end) {
    if (!clock) return name;
    const Minute first(clock->at(begin));
    const Minute last(clock->at(end));
    const std::string heading = fmt::format("{} · {}, {}", name, first.date(), first.time);
    if (last.day != first.day) return fmt::format("{} – {}, {}", heading, last.date(), last.time);
    return last.time == first.time ? heading : fmt::format("{}–{}", heading, last.time);
}

using Json = nlohmann::ordered_json;

constexpr int still_quality = 66;
constexpr int still_side = 240;
constexpr int small_still_side = 200;  // with a preview, a still is shown only until the preview has loaded

/// Rounds a time or rate to six decimals, the precision of containers.
double rounded(double value) {
    return std::round(value * 1e6) / 1e6;
}

/// A PNG with one number per pixel in three bytes. All browsers decode PNG, and no other format is as small without our
/// own decoder.
template <class ValueOf>
Json json_of_pixels(const Plane<float>& pixels, const ValueOf& value_of) {
    Plane<Bgr> picture(pixels.size());
    std::int64_t sum = 0;
    std::ranges::transform(pixels.pixels(), picture.pixels().begin(), [&](float pixel) {
        const std::int64_t value = std::clamp<std::int64_t>(value_of(pixel), 0, 0xFF'FF'FF);
        sum += value;
        const auto byte = [&](int shift) { return static_cast<std::uint8_t>(value >> shift); };
        return Bgr{byte(0), byte(8), byte(16)};
    });
    return {{"src", data_url("image/png", image::encode_picture("pixels.png", picture))}, {"sum", sum}};
}

/// The frame of each pixel: 0 = none, else frame - first + 1.
Json json_of_frames(const Plane<float>& frames, std::int64_t first) {
    Json json = json_of_pixels(frames, [first](float frame) {
        return frame < 0 ? 0 : std::max<std::int64_t>(std::llround(frame) - first + 1, 1);
    });
    json["first"] = first;
    return json;
}

/// Maps an event's number in the picture to its index in the list plus 1; 0 = not in the list.
class Places {
  public:
    explicit Places(const PageContent& content) {
        const std::size_t count = content.events ? content.events->size() : 0;
        for (std::size_t k = 0; k < count; ++k) {
            places_[k < content.numbers.size() ? content.numbers[k] : k + 1] = static_cast<std::int64_t>(k) + 1;
        }
    }

    std::int64_t of(std::size_t number) const {
        const auto found = places_.find(number);
        return found == places_.end() ? 0 : found->second;
    }

  private:
    std::unordered_map<std::size_t, std::int64_t> places_;
};

/// The event that each pixel shows, as index plus 1; 0 = none.
Json json_of_objects(const Plane<float>& objects, const Places& places) {
    if (objects.empty()) return {};
    return json_of_pixels(objects,
                          [&](float number) { return number > 0 ? places.of(static_cast<std::size_t>(number)) : 0; });
}

/// In tenths of a pixel at most.
double tenths(double value) {
    return std::round(value * 10) / 10;
}

Json json_of(const PixelBox& box) {
    return {box.left, box.top, box.right, box.bottom};
}

Json json_of(const Overlay& overlay) {
    Json json{{"sections", Json::array()},    {"notes", Json::array()},     {"portraits", Json::array()},
              {"captions", overlay.captions}, {"numbers", overlay.numbers}, {"map", Json()}};
    for (const Overlay::Section& section : overlay.sections) {
        Json values{rounded(section.seconds)};
        for (const glm::dvec2& corner : section.corners) {
            values.push_back(tenths(corner.x));
            values.push_back(tenths(corner.y));
        }
        json["sections"].push_back(values);
    }
    for (const auto& [text, at, out] : overlay.notes) {
        json["notes"].push_back({{"text", text},
                                 {"at", {tenths(at.x), tenths(at.y)}},
                                 {"out", {std::round(out.x * 1e3) / 1e3, std::round(out.y * 1e3) / 1e3}}});
    }
    for (const auto& [event, still, to] : overlay.portraits) {
        json["portraits"].push_back({{"event", event}, {"box", json_of(still)}, {"to", {tenths(to.x), tenths(to.y)}}});
    }
    if (!overlay.map.empty() && !overlay.scene.empty()) {
        json["map"] = {{"box", json_of(overlay.map)},
                       {"src", data_url("image/jpeg", image::encode_picture("map.jpg", overlay.scene, still_quality))}};
    }
    return json;
}

/// The settings of the picture.
Json json_of(const image::Metadata& settings) {
    Json json = Json::object();
    for (const auto& [name, value] : settings) json[name] = value;
    return json;
}

/// The times at which an object stood still, in frames.
Json json_of(const std::vector<events::Stay>& stays) {
    Json json = Json::array();
    for (const events::Stay& stay : stays) json.push_back({stay.first.frame, stay.last.frame});
    return json;
}

Json json_of(const PageContent::Segment& segment) {
    return {segment.url, rounded(segment.begin), rounded(segment.length)};
}

/// The wall clock: its time at second 0 (seconds since 1970-01-01 00:00 on that clock), its jumps, its time zone and
/// its source.
Json json_of(const WallClock& clock) {
    if (!clock) return {};
    Json leaps = Json::array();
    for (const Clock::ClockChange& leap : clock->changes) leaps.push_back({leap.seconds, leap.by});
    return {{"begin", clock->begin},
            {"leaps", leaps},
            {"zone", clock->zone.empty() ? Json() : Json(clock->zone)},
            {"by", row_of(clock->source).words}};
}

std::string css_of(const glm::vec3& colour) {
    const auto byte = [](float channel) { return static_cast<int>(std::lround(channel * 255)); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.x), byte(colour.y), byte(colour.z));
}

Json json_of(const std::vector<ConstantRateFrames>& times) {
    Json json = Json::array();
    for (const ConstantRateFrames& steady : times) {
        json.push_back({steady.first, steady.count, rounded(steady.begin), steady.step});
    }
    return json;
}

Json number_of(const std::optional<std::size_t>& place) {
    return place ? Json(*place) : Json();
}

/// An object's path in fractions of the picture's width and height, so the page needs no field size.
Json json_of(const std::vector<events::PathPoint>& path, Size field) {
    const auto share = [](double place, int side) { return std::round((place + 0.5) / side * 1e4) / 1e4; };
    Json json = Json::array();
    for (const events::PathPoint& point : path) {
        json.push_back({point.at.frame, share(point.place.x, field.width), share(point.place.y, field.height)});
    }
    return json;
}

/// A box in fractions of the picture's width and height.
Json json_of_place(const PixelBox& box, Size field) {
    const auto share = [](int place, int side) { return std::round(1e4 * place / side) / 1e4; };
    return {share(box.left, field.width), share(box.top, field.height), share(box.right, field.width),
            share(box.bottom, field.height)};
}

/// An object's path in the format of an archive's index.
Json way_of(const std::vector<events::PathPoint>& path, Size field, Size shown) {
    const glm::dvec2 size(shown.width, shown.height);
    const glm::dvec2 scale = size / glm::dvec2(field.width, field.height);
    std::vector<events::Waypoint> way;
    for (const events::PathPoint& point : path) {
        way.push_back(events::waypoint(point.at.seconds, (point.place + 0.5) * scale - 0.5, size));
    }
    Json json = Json::array();
    for (const events::Waypoint& point : events::simplified(way)) {
        for (const int value : {point.time, point.x, point.y}) json.push_back(value);
    }
    return json;
}

Json json_of(const events::Event& event, Size field, Size shown) {
    const auto& identity = event.identity;
    return {{"kind", events::name_of(event.kind)},
            {"class", identity ? Json(identity->what->name) : Json()},
            {"group", identity ? Json(detector::name_of(identity->what->group)) : Json()},
            {"score", identity ? Json(std::round(identity->score * 100) / 100) : Json()},
            {"box", json_of_place(event.box, field)},
            {"first", event.first.frame},
            {"last", event.last.frame},
            {"still", rounded(events::stationary_seconds(event))},
            {"stays", json_of(event.stays)},
            {"from", number_of(event.from)},
            {"into", number_of(event.into)},
            {"by", number_of(event.by)},
            {"path", json_of(event.path, field)},
            {"way", way_of(event.path, field, shown)}};
}

Json json_of_portrait(const Plane<Bgr>& portrait) {
    if (portrait.empty()) return {};
    return data_url("image/jpeg", image::encode_picture("portrait.jpg", portrait, still_quality));
}

/// \param side of the picture, pixels
Json json_of(const Still& still, int side) {
    const Plane<Bgr> small = image::resized(still.picture, fit_into(still.picture.size(), side));
    return {{"frame", still.frame},
            {"src", data_url("image/jpeg", image::encode_picture("still.jpg", small, still_quality))}};
}

Json json_of(const EncodedVideo& film) {
    return {{"type", film.type}, {"begin", rounded(film.begin)}, {"step", film.step}, {"base64", base64(film.bytes)}};
}

Json json_of_events(const PageContent& content) {
    if (!content.events) return {};
    Json json = Json::array();
    for (const events::Event& event : *content.events) json.push_back(json_of(event, content.field, content.shown));
    for (std::size_t k = 0; k < std::min(content.colours.size(), json.size()); ++k) {
        json[k]["colour"] = css_of(content.colours[k]);
    }
    for (std::size_t k = 0; k < std::min(content.numbers.size(), json.size()); ++k) {
        json[k]["number"] = content.numbers[k];
    }
    for (std::size_t k = 0; k < std::min(content.deeds.size(), json.size()); ++k) json[k]["deed"] = content.deeds[k];
    return json;
}

ClockSource source_of(const PageContent& content) {
    return content.clock ? content.clock->source : ClockSource::none;
}

/// What the page needs before anything can be done with it. The rest comes after its script.
Json json_of(const PageContent& content) {
    const Moments& moments = content.moments;
    Json json{{"name", content.name},
              {"camera", content.camera.empty() ? Json() : Json(content.camera)},
              {"clip", content.clip_url.empty() ? Json() : Json(content.clip_url)},
              {"segments", Json::array()},
              {"cut", {{"ending", content.piece_extension}, {"names", content.names}}},
              {"size", {content.shown.width, content.shown.height}},
              {"times", json_of(moments.times)},
              {"clock", json_of(content.clock)},
              {"told", row_of(source_of(content)).words},
              {"kinds", json_of_kinds()},
              {"index", Json()},
              {"live", Json()},
              {"events", json_of_events(content)},
              {"overlay", json_of(content.overlay)},
              {"settings", json_of(content.settings)}};
    if (content.index) json["index"] = {{"url", content.index->url}, {"clip", content.index->clip}};
    if (const auto& live = content.live) {
        json["live"] = {{"state", live->text},
                        {"written", live->written},
                        {"ended", false},
                        {"brick", std::ceil(live->brick_seconds)}};
    }
    for (const PageContent::Segment& segment : content.segments) json["segments"].push_back(json_of(segment));
    return json;
}

Json json_of_pixel_data(const PageContent& content) {
    return {{"pixels", json_of_frames(content.picture.pixel_data.frame, content.moments.times.front().first)},
            {"objects", json_of_objects(content.picture.pixel_data.object, Places(content))}};
}

/// Of the clip and of its events.
Json json_of_stills(const PageContent& content) {
    Json json{{"stills", Json::array()}, {"portraits", Json::array()}};
    const int side = content.moments.preview ? small_still_side : still_side;
    for (const Still& still : content.moments.stills) json["stills"].push_back(json_of(still, side));
    for (const Plane<Bgr>& portrait : content.portraits) json["portraits"].push_back(json_of_portrait(portrait));
    return json;
}

Json json_of_preview(const PageContent& content) {
    return {{"preview", content.moments.preview ? json_of(*content.moments.preview) : Json()}};
}

/// A time in the format of the page's script: "1:15.2", truncated to tenths.
std::string moment_text(double seconds, const WallClock& clock) {
    const auto tenths = static_cast<std::int64_t>(std::floor(seconds * 10 + 1e-4));
    const std::int64_t whole = tenths / 10;
    return fmt::format("{}.{}", labels::format_moment(static_cast<double>(whole), clock), tenths % 10);
}

/// A list of the events for browsers without scripts.
std::string list_of(const PageContent& content) {
    if (!content.events) return {};
    std::string list;
    for (const events::Event& event : *content.events) {
        const events::EventKindRow& row = row_of(event.kind);
        const bool stood = row.tally == events::Tally::still;
        list += fmt::format(
            "<li>{}. {}: {}{}{}</li>\n", &event - content.events->data() + 1,
            moment_text(event.first.seconds, content.clock) + " – " + moment_text(event.last.seconds, content.clock),
            event.identity ? fmt::format("{} ", event.identity->what->name) : "", row.words,
            stood ? fmt::format(" {}", labels::format_duration(events::stationary_seconds(event))) : "");
    }
    return list;
}

/// The picture as a URL. WebP has transparency and is a sixth of a PNG.
std::string url_of_picture(const PageContent& content) {
    constexpr int quality = 90;
    constexpr int most_side = 16383;  // of WebP
    const Size size = content.picture.pixels.size();
    if (std::max(size.width, size.height) > most_side)
        return data_url("image/png", image::encode_picture("page.png", content.picture));
    return data_url("image/webp", image::encode_webp(content.picture.pixels, quality));
}

/// The end of the last frame, seconds.
double end_of(const std::vector<ConstantRateFrames>& times) {
    const ConstantRateFrames& last = times.back();
    return last.at(last.first + last.count);
}

std::int64_t frames_in(const std::vector<ConstantRateFrames>& times) {
    std::int64_t frames = 0;
    for (const ConstantRateFrames& steady : times) frames += steady.count;
    return frames;
}

/// The source of the time of day.
std::string time_source_text(const PageContent& content) {
    const std::string_view words = row_of(source_of(content)).words;
    return content.clock ? fmt::format("times of day {}", words) : std::string(words);
}

/// The direction of time in the picture, as text.
std::string time_direction(const image::Metadata& settings) {
    const auto layout = std::ranges::find(settings, "layout", &image::Metadata::value_type::first);
    const auto row = layout == settings.end()
                         ? space::layouts().begin()
                         : std::ranges::find(space::layouts(), layout->second, &space::LayoutRow::name);
    return row == space::layouts().end() ? std::string() : row->time_direction;
}

}  // namespace

std::string make_page(const PageContent& content) {
    const Size size = content.picture.pixels.size();
    const std::string style = std::string(web::theme_css) + std::string(web::page_css);
    const std::string script(web::page_js);
    const std::string arrival = "vvr.takeParts();";  // of the parts that follow the script
    const std::string plain = ".scripted { display: none !important; }";
    const auto json_text_of = [](const Json& json) { return script_json(json_text(json, -1, true)); };
    // Replaces bytes that are not UTF-8 by U+FFFD. The clip's URL is already escaped.
    const auto shown = [](const std::string& text) {
        return html_text(Json::parse(json_text(text)).get<std::string>());
    };
    const double begin = content.moments.times.front().begin;
    const double end = end_of(content.moments.times);
    return fill(
        web::page_html,
        {
            {"script policy", policy_hash(script) + " " + policy_hash(arrival)},
            {"style policy", policy_hash(style) + " " + policy_hash(plain)},
            {"connect", content.live ? "; connect-src 'self'" : ""},
            {"name", shown(content.name)},
            {"heading",
             shown(heading_of(content.camera.empty() ? content.name : content.camera, content.clock, begin, end))},
            {"file", shown(content.file)},
            {"summary", fmt::format("{} to {}, {}; {}", labels::format_moment(std::floor(begin), content.clock),
                                    labels::format_moment(std::floor(end + 1e-4), content.clock),
                                    counted(frames_in(content.moments.times), "frame"), time_source_text(content))},
            {"way", time_direction(content.settings)},
            {"list", list_of(content)},
            {"first kind", std::string(events::ranked_kinds().front().words)},
            {"style", style},
            {"script", script},
            {"picture", url_of_picture(content)},
            {"width", fmt::to_string(size.width)},
            {"height", fmt::to_string(size.height)},
            {"plain", plain},
            {"arrival", arrival},
            {"data", json_text_of(json_of(content))},
            {"pixel data", json_text_of(json_of_pixel_data(content))},
            {"stills", json_text_of(json_of_stills(content))},
            {"preview", json_text_of(json_of_preview(content))},
        });
}

std::string with_ended_stream(std::string page) {
    constexpr std::string_view before = "\"ended\":false";
    const std::size_t place = page.find(before);  // of the data: in texts, quotes are escaped
    if (place != std::string::npos) page.replace(place, before.size(), "\"ended\":true");
    return page;
}

std::string make_region_editor(const RegionEditorContent& content) {
    constexpr int quality = 88;
    const bool masks = content.roi.empty() && !content.mask.empty();
    const nlohmann::ordered_json data{{"option", masks ? "mask" : "roi"},
                                      {"regions", masks ? content.mask : content.roi}};
    // Replaces bytes that are not UTF-8 by U+FFFD.
    const std::string name = nlohmann::ordered_json::parse(json_text(content.name));
    const std::string style = std::string(web::theme_css) + std::string(web::region_editor_css);
    const std::string script(web::region_editor_js);
    return fill(web::region_editor_html,
                {
                    {"script policy", policy_hash(script)},
                    {"style policy", policy_hash(style)},
                    {"name", html_text(name)},
                    {"moment", html_text(content.moment)},
                    {"style", style},
                    {"script", script},
                    {"frame", data_url("image/jpeg", image::encode_picture("frame.jpg", content.frame, quality))},
                    {"width", fmt::to_string(content.frame.width())},
                    {"height", fmt::to_string(content.frame.height())},
                    {"data", script_json(json_text(data, -1, true))},
                });
}

}  // namespace vvr::page
