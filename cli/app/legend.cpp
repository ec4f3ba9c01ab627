#include "cli/app/legend.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/fields/field.h"
#include "core/scene/slices.h"
#include "core/scene/theme.h"

namespace vvr::app {

namespace {

std::vector<image::Rgba> gradient(const glm::vec3& from, const glm::vec3& to) {
    constexpr int steps = 64;
    std::vector<image::Rgba> colours;
    for (int i = 0; i < steps; ++i) colours.push_back(rgba(glm::mix(from, to, static_cast<float>(i) / (steps - 1))));
    return colours;
}

/// The colours of values, as seen through an object about as thick as a person's track.
std::vector<image::Rgba> transfer_gradient(const scene::TransferFunction& transfer, int low,
                                           const glm::vec4& background) {
    std::vector<image::Rgba> colours;
    for (int value = low; value < 256; ++value) {
        const glm::dvec4 at = transfer.at(value);
        const auto opacity = static_cast<float>(1 - std::exp(-at.w * scene::opacity_unit_distance * 2));
        const glm::vec4 colour = glm::vec4(glm::vec3(at) * opacity, opacity) + background * (1 - opacity);
        colours.push_back({colour.x, colour.y, colour.z, colour.w});
    }
    return colours;
}

int first_visible(const scene::TransferFunction& transfer) {
    int value = 0;
    while (value < 255 && !transfer.visible({0, static_cast<std::uint8_t>(value)})) ++value;
    return value;
}

std::vector<image::Rgba> colours_of_objects(const scene::Theme& theme) {
    std::vector<image::Rgba> colours;
    for (const glm::vec3& colour : theme.objects) colours.push_back(rgba(colour));
    return colours;
}

/// One entry per band: its colour and meaning.
std::vector<labels::LegendEntry> legend_of_bands(const scene::TransferFunction& transfer) {
    constexpr std::array<std::pair<fields::Band, std::string_view>, 3> bands{
        {{fields::Band::newly_covered, "newly covered"},
         {fields::Band::still_covered, "still covered"},
         {fields::Band::uncovered, "uncovered"}}};
    std::vector<labels::LegendEntry> entries;
    for (const auto& [band, name] : bands) {
        const glm::dvec4 at = transfer.at(static_cast<int>(band));
        if (at.w > 0) entries.push_back({{rgba(glm::vec3(at))}, std::string(name), std::string(name)});
    }
    return entries;
}

/// The entries for volume colours that don't come from the transfer function.
std::vector<labels::LegendEntry> legend_of_colour(const Plan& plan) {
    const ColourRow& row = *plan.colour;
    if (row.needs_pictures) return {{{}, "in the video's own colours", "video"}};
    if (row.drawn == gl::VolumeColour::time) {
        std::vector<image::Rgba> colours;
        for (const glm::vec4& colour : scene::time_colours()) colours.push_back(rgba(glm::vec3(colour)));
        return {{std::move(colours), "time, from the first moment to the last", "time"}};
    }
    if (row.of_direction) {
        constexpr int spokes = 48;
        std::vector<image::Rgba> colours;
        for (int i = 0; i < spokes; ++i) {
            const double angle = 2 * std::numbers::pi * i / spokes;
            colours.push_back(rgba(scene::direction_colour({std::cos(angle), -std::sin(angle)})));
        }
        return {{std::move(colours), "which way it moves in the view of the camera", "direction", true},
                {{rgba(plan.job.look.theme.unowned)}, "at rest", "at rest"}};
    }
    if (row.needs_flow) {
        return {{gradient(plan.job.look.theme.slow, plan.job.look.theme.fast), "how fast it moves: slow to fast",
                 "slow to fast"}};
    }
    const scene::TransferFunction& transfer = plan.second_transfer;
    const fields::FilterRow& second = *plan.second;
    if (second.traits.values == fields::Values::band) return legend_of_bands(transfer);
    std::vector<image::Rgba> colours;
    for (int value = second.traits.values == fields::Values::sign ? 1 : 0; value < 256; ++value) {
        colours.push_back(rgba(glm::vec3(transfer.at(value))));
    }
    return {{std::move(colours), fmt::format("colour: {}, little to much", second.help), std::string(second.name)}};
}

/// The entries for colours from the transfer function.
std::vector<labels::LegendEntry> legend_of_transfer(const Plan& plan) {
    const fields::FilterRow& filter = *plan.filter;
    switch (filter.traits.values) {
        case fields::Values::band:
            return legend_of_bands(plan.drawn_transfer);
        case fields::Values::sign:
            return {{transfer_gradient(plan.drawn_transfer, 1, plan.picture.background),
                     "darker to brighter than the empty scene", "darker to brighter"}};
        case fields::Values::strength:
            break;
    }
    return {{transfer_gradient(plan.drawn_transfer, first_visible(plan.transfer), plan.picture.background),
             fmt::format("{}: little to much", filter.help), std::string(filter.name)}};
}

std::vector<labels::LegendEntry> legend_of_volume(const Plan& plan) {
    if (plan.colour->drawn == gl::VolumeColour::transfer) return legend_of_transfer(plan);
    if (!plan.colours_objects()) return legend_of_colour(plan);
    return {{colours_of_objects(plan.job.look.theme), "a colour for each object, striped where it stood", "objects"},
            {{rgba(plan.job.look.theme.unowned)}, "other changes", "other"}};
}

}  // namespace

std::vector<labels::LegendEntry> legend_of(const Plan& plan) {
    std::vector<labels::LegendEntry> entries;
    if (plan.shows(Part::volume)) entries = legend_of_volume(plan);
    const gl::GlyphStyle& style = plan.picture.glyphs;
    const auto flow = [&](const std::string& what) {
        return labels::LegendEntry{gradient(style.slow_colour, style.fast_colour),
                                   fmt::format("{}: slow to fast", what), "slow to fast"};
    };
    if (plan.shows(Part::arrows) || (plan.shows(Part::directions) && !plan.colours_objects())) {
        entries.push_back(flow("which way it went"));
    } else if (plan.shows(Part::tracelines)) {
        entries.push_back(flow("paths of the flow"));
    }
    return entries;
}

}  // namespace vvr::app
