#include "cli/options/look.h"

#include <algorithm>
#include <charconv>
#include <ctime>
#include <iomanip>
#include <sstream>

#include <fmt/format.h>

#include "cli/render/render_clip.h"
#include "cli/options/option.h"

namespace vvr {

namespace {

std::vector<std::string> parse_parts(const std::string& text) {
    std::vector<std::string> shown;
    for (const std::string& word : CLI::detail::split(text, ',')) shown.push_back(parse_name(word, show_words()));
    return shown;
}

/// A colour multiplied by its opacity.
glm::vec4 parse_colour(const std::string& text) {
    if (text == "none") return glm::vec4(0);
    unsigned value = 0;
    const char* const end = text.data() + text.size();
    const bool hex = text.size() == 7 && text[0] == '#' && std::from_chars(text.data() + 1, end, value, 16).ptr == end;
    if (!hex) throw Error(ErrorKind::usage, fmt::format("'{}': a colour is #rrggbb, or none", text));
    return {static_cast<float>(value >> 16 & 255U) / 255, static_cast<float>(value >> 8 & 255U) / 255,
            static_cast<float>(value & 255U) / 255, 1};
}

StartTime parse_start(const std::string& text) {
    if (text == "recorded") return {true, {}};
    for (const char* form : {"%Y-%m-%d %H:%M:%S", "%Y-%m-%dT%H:%M:%S", "%Y-%m-%d %H:%M", "%Y-%m-%dT%H:%M"}) {
        std::tm parts{};
        std::istringstream stream(text);
        stream >> std::get_time(&parts, form);
        if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof()) continue;
        const std::tm asked = parts;
        const std::time_t seconds = timegm(&parts);
        // 30 February would become a day in March.
        if (asked.tm_mday == parts.tm_mday && asked.tm_mon == parts.tm_mon) return {false, seconds};
    }
    throw Error(ErrorKind::usage,
                fmt::format("'{}': a date and time is written 2026-11-21 08:00:00; or it is 'recorded'", text));
}

}  // namespace

WallClock clock_of(const StartTime& start, const VideoInfo& info) {
    if (!start.as_recorded) return start.clock;
    if (info.created) return info.created;
    throw Error(ErrorKind::usage, fmt::format("--start-time recorded: '{}' does not say when it was recorded; give the "
                                              "date and time",
                                              info.name));
}

glm::vec4 LookOptions::background_colour() const {
    return background.empty() ? glm::vec4(find_theme(theme).background, 1) : parse_colour(background);
}

bool LookOptions::shows(const std::string& part) const {
    return std::ranges::count(show, part) > 0;
}

VolumeColour LookOptions::volume_colour() const {
    return std::ranges::find(volume_colours(), colour, &VolumeColourRow::name)->colour;
}

VolumeShading LookOptions::volume_shading() const {
    return std::ranges::find(volume_shadings(), shading, &VolumeShadingRow::name)->shading;
}

void add_options(CLI::App& app, LookOptions& options) {
    add_option(app, group::look, options.show,
               {"--show", "LIST", fmt::format("{}", fmt::join(options.show, ",")),
                fmt::format("what is drawn, of {}", fmt::join(show_words(), ", "))},
               parse_parts);
    add_integer(app, group::look, options.keyframes, 0, 32,
                {"--keyframes", "COUNT", "", "frames that stand in the volume between the first and the last"});
    add_choice(app, group::look, options.theme, themes(),
               {"--theme", "NAME", "", "colours of all that isn't the video's"});
    add_option(app, group::look, options.background,
               {"--background", "COLOR", "", "#rrggbb, or none for a transparent picture; the theme's if not given"},
               [](const std::string& given) {
                   parse_colour(given);
                   return given;
               });
    add_text(app, group::look, options.title,
             {"--title", "TEXT", "", "above the picture; the clip's name if not given"});
    add_option(
        app, group::look, options.start_time,
        {"--start-time", "DATETIME", "",
         "when the clip began, 2026-11-21 08:00:00, or recorded as the container says: the ruler shows a clock's time"},
        parse_start);
    add_option(app, group::look, options.transfer,
               {"--transfer", "NAME", "the theme's",
                fmt::format("colour and opacity of the volume's values: {}, or a file of points",
                            fmt::join(names_of(transfer_functions()), ", "))},
               [](const std::string& given) {
                   find_transfer(given);  // now, not when the clip has been read
                   return given;
               });
    add_name(app, group::look, options.colour, names_of(volume_colours()),
             {"--color", "NAME", "", "the volume's colour, the transfer function's or the video's own"});
    add_choice(app, group::look, options.shading, volume_shadings(), {"--shading", "NAME", "", "light on the volume"});
    add_number(app, group::look, options.opacity, {0, 1000},
               {"--opacity", "FACTOR", "", "factor on the volume's opacity"});
    add_number(app, group::look, options.glyph_scale, {0.01, 100},
               {"--glyph-scale", "FACTOR", "", "factor on the arrows' size"});
    add_integer(app, group::look, options.traces.steps, 1, 100'000,
                {"--trace-steps", "COUNT", "", "steps of a traceline"});
    add_number(app, group::look, options.traces.dt, {1e-3, 1000},
               {"--trace-dt", "FRAMES", "", "length of a traceline's step in time"});
    add_number(app, group::look, options.traces.time_velocity, {-1000, 1000},
               {"--time-velocity", "NUMBER", "",
                "frames along the arc that flow takes a frame; 0 = arrows and tracelines stay in their frame"});
}

}  // namespace vvr
