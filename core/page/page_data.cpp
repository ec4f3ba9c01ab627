#include "core/page/page_data.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/image/picture_file.h"
#include "core/page/html.h"
#include "core/tracking/path.h"

namespace vvr::page {

namespace {

constexpr int still_quality = 66;
constexpr int inline_still_side = 240;
constexpr int small_inline_still_side = 200;  // with a preview, a still is shown only until the preview has loaded

/// The precision of times and rates in containers.
double to_six_decimals(double value) {
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
            places_[content.number_of(k)] = static_cast<std::int64_t>(k) + 1;
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
    const auto section = [](const Overlay::Section& of) {
        Json values{to_six_decimals(of.seconds)};
        for (const glm::dvec2& corner : of.corners) values.insert(values.end(), {tenths(corner.x), tenths(corner.y)});
        return values;
    };
    const auto place = [](const glm::dvec2& at) { return Json{tenths(at.x), tenths(at.y)}; };
    const auto note = [&](const auto& of) {
        return Json{{"text", of.text},
                    {"t", std::round(of.t * 1e4) / 1e4},
                    {"at", place(of.at)},
                    {"out", {rounded(of.out.x), rounded(of.out.y)}}};
    };
    const auto portrait = [&](const auto& of) {
        Json object = Json::array();
        for (int k = 0; k < 4; ++k) object.push_back(std::round(of.object[k] * 1e3) / 1e3);
        return Json{{"event", of.event}, {"box", json_of(of.still)}, {"object", object}, {"to", place(of.to)}};
    };
    Json json{{"sections", list_of(overlay.sections, section)},
              {"notes", list_of(overlay.notes, note)},
              {"portraits", list_of(overlay.portraits, portrait)},
              {"captions", overlay.captions},
              {"numbers", overlay.numbers},
              {"map", Json()}};
    if (!overlay.map.empty() && !overlay.scene.empty()) {
        json["map"] = {{"box", json_of(overlay.map)},
                       {"src", data_url("image/jpeg", image::encode_picture("map.jpg", overlay.scene, still_quality))}};
    }
    return json;
}

Json json_of(const PageContent::Segment& segment) {
    return {segment.url, to_six_decimals(segment.begin), to_six_decimals(segment.length)};
}

/// The wall clock: its time at second 0 (seconds since 1970-01-01 00:00 on that clock), its jumps, its time zone and
/// its source.
Json json_of(const WallClock& clock) {
    if (!clock) return {};
    const auto leap = [](const Clock::ClockChange& change) { return Json{change.seconds, change.by}; };
    return {{"begin", clock->begin},
            {"leaps", list_of(clock->changes, leap)},
            {"zone", or_null(clock->zone)},
            {"by", row_of(clock->source).words}};
}

std::string css_of(const glm::vec3& colour) {
    const auto byte = [](float channel) { return static_cast<int>(std::lround(channel * 255)); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.x), byte(colour.y), byte(colour.z));
}

Json json_of(const ConstantRateFrames& steady) {
    return {steady.first, steady.count, to_six_decimals(steady.begin), steady.step};
}

/// The reason for each gap: where the numbers of frames skip.
Json json_of_gaps(const std::vector<ConstantRateFrames>& times, const PageContent& content) {
    std::vector<media::SegmentPlace> files;
    for (const PageContent::Segment& file : content.segments)
        files.push_back({"", file.begin, file.begin + file.length});
    Json json = Json::array();
    for (std::size_t k = 1; k < times.size(); ++k) {
        const std::int64_t next = times[k - 1].first + times[k - 1].count;
        if (times[k].first > next)
            json.push_back(
                media::reason_for_gap(content.span, files, content.missing, times[k - 1].at(next), times[k].begin));
    }
    return json;
}

/// An object's path in fractions of the picture's width and height, so the page needs no field size.
Json json_of(const std::vector<tracking::PathPoint>& path, Size field) {
    const auto share = [](double place, int side) { return std::round((place + 0.5) / side * 1e4) / 1e4; };
    return list_of(path, [&](const tracking::PathPoint& point) {
        return Json{point.at.frame, share(point.place.x, field.width), share(point.place.y, field.height)};
    });
}

/// A box in fractions of the picture's width and height.
Json json_of_place(const PixelBox& box, Size field) {
    const auto share = [](int place, int side) { return std::round(1e4 * place / side) / 1e4; };
    return {share(box.left, field.width), share(box.top, field.height), share(box.right, field.width),
            share(box.bottom, field.height)};
}

/// An object's path in the format of an archive's index.
Json way_of(const std::vector<tracking::PathPoint>& path, Size field, Size shown) {
    const glm::dvec2 size(shown.width, shown.height);
    const glm::dvec2 scale = size / glm::dvec2(field.width, field.height);
    std::vector<tracking::Waypoint> way;
    for (const tracking::PathPoint& point : path) {
        way.push_back(tracking::waypoint(point.at.seconds, (point.place + 0.5) * scale - 0.5, size));
    }
    Json json = Json::array();
    for (const auto& [time, x, y] : tracking::simplified(way)) json.insert(json.end(), {time, x, y});
    return json;
}

Json json_of(const tracking::Event& event, Size field, Size shown) {
    const auto& identity = event.identity;
    const auto frames_of = [](const tracking::Stay& stay) { return Json{stay.first.frame, stay.last.frame}; };
    return {{"kind", tracking::name_of(event.kind)},
            {"class", identity ? Json(identity->what->name) : Json()},
            {"group", identity ? Json(detector::name_of(identity->what->group)) : Json()},
            {"score", identity ? Json(std::round(identity->score * 100) / 100) : Json()},
            {"box", json_of_place(event.box, field)},
            {"first", event.first.frame},
            {"last", event.last.frame},
            {"begin", to_six_decimals(event.first.seconds)},
            {"end", to_six_decimals(event.last.seconds)},
            {"still", to_six_decimals(tracking::stationary_seconds(event))},
            {"stays", list_of(event.stays, frames_of)},
            {"from", or_null(event.from)},
            {"into", or_null(event.into)},
            {"by", or_null(event.by)},
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
    return {{"type", film.type},
            {"begin", to_six_decimals(film.begin)},
            {"step", film.step},
            {"base64", base64(film.bytes)}};
}

Json json_of_events(const PageContent& content) {
    if (!content.events) return {};
    Json json =
        list_of(*content.events, [&](const auto& event) { return json_of(event, content.field, content.shown); });
    for (std::size_t k = 0; k < std::min(content.colours.size(), json.size()); ++k) {
        json[k]["colour"] = css_of(content.colours[k]);
    }
    for (std::size_t k = 0; k < std::min(content.numbers.size(), json.size()); ++k) {
        json[k]["number"] = content.numbers[k];
    }
    for (std::size_t k = 0; k < std::min(content.activities.size(), json.size()); ++k)
        json[k]["deed"] = content.activities[k];
    return json;
}

}  // namespace

Json page_data(const PageContent& content) {
    const Moments& moments = content.moments;
    const auto json_of_each = [](const auto& each) { return json_of(each); };
    const auto span_of = [](const media::Damage& damage) {
        return Json{to_six_decimals(damage.begin), to_six_decimals(damage.end)};
    };
    Json json{{"name", content.name},
              {"camera", or_null(content.camera)},
              {"clip", or_null(content.clip_url)},
              {"segments", list_of(content.segments, json_of_each)},
              {"pieces", list_of(content.pieces, json_of_each)},
              {"cut", {{"ending", content.piece_extension}, {"names", content.names}}},
              {"size", {content.shown.width, content.shown.height}},
              {"times", list_of(moments.times, json_of_each)},
              {"gaps", json_of_gaps(moments.times, content)},
              {"unseen", words_of(content.unseen)},
              {"damage", list_of(content.unseen.damage, span_of)},
              {"clock", json_of(content.clock)},
              {"told", row_of(content.clock_source()).words},
              {"kinds", json_of_kinds()},
              {"index", Json()},
              {"live", Json()},
              {"unchosen", content.not_chosen},
              {"events", json_of_events(content)},
              {"overlay", json_of(content.overlay)},
              {"settings", object_of(content.settings)}};
    if (!content.films.empty()) json["films"] = list_of(content.films, json_of_each);
    if (content.stretch != 1) json["stretch"] = content.stretch;
    if (content.index) json["index"] = {{"url", content.index->url}, {"clip", content.index->clip}};
    if (const auto& live = content.live) {
        json["live"] = {{"state", live->text},
                        {"written", live->written},
                        {"ended", false},
                        {"brick", std::ceil(live->brick_seconds)}};
    }
    return json;
}

Json pixel_data(const PageContent& content) {
    return {{"pixels", json_of_frames(content.picture.pixel_data.frame, content.moments.times.front().first)},
            {"objects", json_of_objects(content.picture.pixel_data.object, Places(content))}};
}

Json still_data(const PageContent& content) {
    const int side = content.moments.preview ? small_inline_still_side : inline_still_side;
    return {{"stills", list_of(content.moments.stills, [&](const Still& still) { return json_of(still, side); })},
            {"portraits", list_of(content.portraits, json_of_portrait)}};
}

Json preview_data(const PageContent& content) {
    return {{"preview", content.moments.preview ? json_of(*content.moments.preview) : Json()}};
}

}  // namespace vvr::page
