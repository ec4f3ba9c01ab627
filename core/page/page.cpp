#include "core/page/page.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/annotation/time_ticks.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/base/wall_clock.h"
#include "core/image/picture_file.h"
#include "core/page/html.h"
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

const std::string& name_in_heading(const PageContent& content) {
    if (!content.heading.empty()) return content.heading;
    return content.camera.empty() ? content.name : content.camera;
}

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

/// A time in the format of the page's script: "1:15.2", truncated to tenths.
std::string moment_text(double seconds, const WallClock& clock) {
    const auto tenths = static_cast<std::int64_t>(std::floor(seconds * 10 + 1e-4));
    const std::int64_t whole = tenths / 10;
    return fmt::format("{}.{}", annotation::format_moment(static_cast<double>(whole), clock), tenths % 10);
}

/// A list of the events for browsers without scripts.
std::string event_list(const PageContent& content) {
    if (!content.events) return {};
    std::string list;
    for (std::size_t k = 0; k < content.events->size(); ++k) {
        const tracking::Event& event = (*content.events)[k];
        list += fmt::format(
            "<li>{}. {}: {}{}</li>\n", content.number_of(k),
            moment_text(event.first.seconds, content.clock) + " – " + moment_text(event.last.seconds, content.clock),
            event.identity ? fmt::format("{} ", event.identity->what->name) : "",
            k < content.activities.size() ? std::string_view(content.activities[k]) : row_of(event.kind).words);
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

/// When the last frame was, seconds.
double last_frame_of(const std::vector<ConstantRateFrames>& times) {
    const ConstantRateFrames& last = times.back();
    return last.at(last.first + last.count - 1);
}

/// The source of the time of day.
std::string time_source_text(const PageContent& content) {
    const std::string_view words = row_of(content.clock_source()).words;
    return content.clock ? fmt::format("times of day {}", words) : std::string(words);
}

/// What nobody looked at; empty if there is nothing.
std::string unseen_text(const PageContent& content) {
    const std::vector<std::string> words = words_of(content.unseen);
    return words.empty() ? "" : fmt::format("Not seen: {}", fmt::join(words, "; "));
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
    // As in the picture's title and in the script: of the first and the last frame.
    const double end = last_frame_of(content.moments.times);
    return fill(web::page_html,
                {
                    {"script policy", policy_hash(script) + " " + policy_hash(arrival)},
                    {"style policy", policy_hash(style) + " " + policy_hash(plain)},
                    {"connect", content.live ? "; connect-src 'self'" : ""},
                    {"name", shown(content.name)},
                    {"heading", shown(heading_of(name_in_heading(content), content.clock, begin, end))},
                    {"file", shown(content.file)},
                    {"summary", fmt::format("{} to {}{}; {}", annotation::format_moment(begin, content.clock),
                                            annotation::format_moment(end, content.clock),
                                            content.events ? ", " + counted(content.events->size(), "event") : "",
                                            time_source_text(content))},
                    {"unseen", unseen_text(content)},
                    {"list", event_list(content)},
                    {"first kind", std::string(tracking::ranked_kinds().front().words)},
                    {"style", style},
                    {"script", script},
                    {"picture", url_of_picture(content)},
                    {"width", fmt::to_string(size.width)},
                    {"height", fmt::to_string(size.height)},
                    {"plain", plain},
                    {"arrival", arrival},
                    {"data", json_text_of(page_data(content))},
                    {"pixel data", json_text_of(pixel_data(content))},
                    {"stills", json_text_of(still_data(content))},
                    {"volume", json_text_of(Json{{"volume", content.turning}})},
                    {"preview", json_text_of(preview_data(content))},
                });
}

std::string with_ended_stream(std::string page) {
    constexpr std::string_view before = "\"ended\":false";
    const std::size_t place = page.find(before);  // of the data: in texts, quotes are escaped
    if (place != std::string::npos) page.replace(place, before.size(), "\"ended\":true");
    return page;
}

std::string with_state(std::string page, const std::string& state) {
    constexpr std::string_view before = "\"live\":{\"state\":\"";
    const std::size_t place = page.find(before);
    if (place == std::string::npos) return page;
    const std::size_t begin = place + before.size();
    return page.replace(begin, page.find('"', begin) - begin, state);
}

std::string make_region_editor(const RegionEditorContent& content) {
    constexpr int quality = 88;
    const bool masks = content.roi.empty() && !content.mask.empty();
    const Json data{{"option", masks ? "mask" : "roi"}, {"regions", masks ? content.mask : content.roi}};
    // Replaces bytes that are not UTF-8 by U+FFFD.
    const std::string name = Json::parse(json_text(content.name));
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
