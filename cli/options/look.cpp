#include <charconv>
#include <sstream>

#include "cli/app/settings.h"
#include "cli/app/volume_paint.h"
#include "cli/options/job_options.h"
#include "cli/options/parse_value.h"
#include "core/base/error.h"
#include "core/fields/filter.h"
#include "core/scene/transfer_file.h"

namespace vvr::options {

namespace {

app::Parts parse_parts(const std::string& text) {
    app::Parts shown;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');)
        shown.add(choose(setting::show.name, word, app::parts()).part);
    return shown;
}

std::string text_of(const app::Parts& shown) {
    std::string text;
    for (const app::PartRow& row : app::parts()) {
        if (shown.has(row.part)) text += fmt::format("{}{}", text.empty() ? "" : ",", row.name);
    }
    return text;
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

/// The transfer functions that themes have, and filters that have one of their own.
std::string default_transfers() {
    std::string text =
        defaults_of(scene::themes(), [](const scene::Theme& theme) { return std::string(theme.transfer); });
    for (const fields::FilterRow& filter : fields::filters()) {
        if (!filter.transfer.empty()) text += fmt::format("; {}: {}", filter.name, filter.transfer);
    }
    return text;
}

}  // namespace

app::StartTime parse_start_time(const std::string& text) {
    using From = app::StartTime::From;
    constexpr std::pair<std::string_view, From> words[] = {{"recorded", From::recorded},
                                                           {"container", From::container},
                                                           {"modified", From::modified},
                                                           {"none", From::none}};
    for (const auto& [word, from] : words) {
        if (text == word) return {from};
    }
    if (const auto seconds = parse_date_time(text)) return {From::given, *seconds};
    throw Error(ErrorKind::usage, fmt::format("'{}': a date and time is written 2026-11-21 08:00:00; or it is "
                                              "'recorded', 'container', 'modified' or 'none'. To begin later in the "
                                              "clip, take --start",
                                              text));
}

void add_start_time_option(CommandLine& line, app::StartTime& start) {
    line.value(Group::look, setting::start_time, "",
               [&start](const std::string& given) { start = parse_start_time(given); },
               {.defaults = std::string(setting::start_time.default_text)});
}

void add_look_options(CommandLine& line, app::RenderJob& job) {
    constexpr Group group = Group::look;
    app::LookOptions& look = job.look;
    line.value(group, setting::show, text_of(look.show),
               [&look](const std::string& given) { look.show = parse_parts(given); },
               {.values = values_of(app::parts())});
    line.number(group, look.keyframes, setting::keyframes);
    line.choice(group, scene::themes(), look.theme.name, setting::theme,
                [&look](const scene::Theme& row) { look.theme = row; });
    line.value(group, setting::background, "",
               [&look](const std::string& given) { look.background = parse_colour(given); });
    line.text(group, look.title, setting::title);
    line.path(group, look.font, setting::font);
    add_start_time_option(line, look.start_time);
    line.value(
        group, setting::transfer, std::string(setting::transfer.default_text),
        [&look](const std::string& given) { look.transfer = scene::find_transfer(given); },
        {.help = list_of(scene::transfer_functions()) + ", or a file of points", .defaults = default_transfers()});
    line.choice(group, app::colour_rows(), look.colour, setting::colour);
    line.choice(group, gl::volume_shadings(), gl::volume_shadings().front().name, setting::shading,
                [&job](const gl::VolumeShadingRow& row) { job.picture.shading = row.shading; });
    line.number(group, look.opacity, setting::opacity);
    line.number(group, look.glyph_scale, setting::glyph_scale);
    line.number(group, look.glyph_cap, setting::glyph_cap);
    line.number(group, look.traces.steps, setting::trace_steps);
    line.number(group, look.traces.dt, setting::trace_dt);
    line.number(group, look.traces.rest, setting::trace_rest);
    line.number(group, look.traces.time_velocity, setting::time_velocity);
}

}  // namespace vvr::options
