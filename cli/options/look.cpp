#include "cli/options/look.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/options/option.h"
#include "cli/work/render_clip.h"

namespace vvr {

namespace {

std::vector<std::string> parse_parts(const std::string& text) {
    std::vector<std::string> shown;
    for (const std::string& word : CLI::detail::split(text, ',')) shown.push_back(parse_name(word, show_words()));
    return shown;
}

}  // namespace

bool LookOptions::shows(const std::string& part) const {
    return std::ranges::count(show, part) > 0;
}

VolumeColour LookOptions::volume_colour() const {
    return std::ranges::find(volume_colours(), colour, &VolumeColourRow::name)->colour;
}

void add_options(CLI::App& app, LookOptions& options) {
    add_option(app, group::look, options.show,
               {"--show", "LIST", fmt::format("{}", fmt::join(options.show, ",")),
                fmt::format("what is drawn, of {}", fmt::join(show_words(), ", "))},
               parse_parts);
    add_option(app, group::look, options.transfer,
               {"--transfer", "NAME", options.transfer,
                fmt::format("colour and opacity of the volume's values: {}, or a file of points",
                            fmt::join(names_of(transfer_functions()), ", "))},
               [](const std::string& given) {
                   find_transfer(given);  // now, not when the clip has been read
                   return given;
               });
    add_name(app, group::look, options.colour, names_of(volume_colours()),
             {"--color", "NAME", "", "the volume's colour, the transfer function's or the video's own"});
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
