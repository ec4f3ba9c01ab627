#include "cli/app/compose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "cli/app/volume_paint.h"
#include "core/base/text.h"
#include "core/events/colouring.h"
#include "core/fields/filter.h"
#include "core/glance/portraits.h"
#include "core/glance/scene_map.h"
#include "core/glance/time_strip.h"
#include "core/labels/sheet.h"
#include "core/scene/overlay.h"
#include "core/scene/slices.h"
#include "core/scene/theme.h"
#include "core/scene/transfer_function.h"

namespace vvr::app {

namespace {

image::Rgba rgba(const glm::vec3& colour) {
    return {colour.x, colour.y, colour.z, 1};
}

std::vector<image::Rgba> gradient(const glm::vec3& from, const glm::vec3& to) {
    constexpr int steps = 64;
    std::vector<image::Rgba> colours;
    for (int i = 0; i < steps; ++i) colours.push_back(rgba(glm::mix(from, to, static_cast<float>(i) / (steps - 1))));
    return colours;
}

/// What a thing as thick as a person's track looks like, by its value.
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

/// Each band in its colour, and what that means.
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

/// The colours of a volume that are not the transfer function's, and what they mean.
std::vector<labels::LegendEntry> legend_of_colour(const RenderJob& job) {
    const ColourRow& row = *job.look.colour;
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
                {{rgba(job.look.theme.unowned)}, "at rest", "at rest"}};
    }
    if (row.needs_flow) {
        return {
            {gradient(job.look.theme.slow, job.look.theme.fast), "how fast it moves: slow to fast", "slow to fast"}};
    }
    const scene::TransferFunction transfer = second_transfer_of(job);
    const fields::FilterRow& second = *row.filter;
    if (second.traits.values == fields::Values::band) return legend_of_bands(transfer);
    std::vector<image::Rgba> colours;
    for (int value = second.traits.values == fields::Values::sign ? 1 : 0; value < 256; ++value) {
        colours.push_back(rgba(glm::vec3(transfer.at(value))));
    }
    return {{std::move(colours), fmt::format("colour: {}, little to much", second.help), std::string(second.name)}};
}

std::vector<labels::LegendEntry> legend_of(const RenderJob& job) {
    std::vector<labels::LegendEntry> entries;
    const fields::FilterRow& filter = *job.fields.filter;
    const bool by_transfer = job.look.show.has(Part::volume) && job.picture.colour == gl::VolumeColour::transfer;
    if (by_transfer && filter.traits.values == fields::Values::band)
        entries = legend_of_bands(drawn_transfer_of(job.look));
    if (by_transfer && filter.traits.values == fields::Values::sign) {
        entries.push_back({transfer_gradient(drawn_transfer_of(job.look), 1, background_of(job.look)),
                           "darker to brighter than the empty scene", "darker to brighter"});
    }
    if (by_transfer && filter.traits.values == fields::Values::strength) {
        const scene::TransferFunction transfer = transfer_of(job.look);
        const int low = first_visible(transfer);
        entries.push_back({transfer_gradient(drawn_transfer_of(job.look), low, background_of(job.look)),
                           fmt::format("{}: little to much", filter.help), std::string(filter.name)});
    }
    if (job.look.show.has(Part::volume) && job.picture.colour == gl::VolumeColour::object) {
        entries.push_back(
            {colours_of_objects(job.look.theme), "a colour for each object, striped where it stood", "objects"});
        entries.push_back({{rgba(job.look.theme.unowned)}, "other changes", "other"});
    }
    const bool of_another = job.picture.colour == gl::VolumeColour::own || job.picture.colour == gl::VolumeColour::time;
    if (job.look.show.has(Part::volume) && of_another) entries = legend_of_colour(job);
    const gl::GlyphStyle style = glyph_style_of(job);
    const auto flow = [&](const std::string& what) {
        return labels::LegendEntry{gradient(style.slow_colour, style.fast_colour),
                                   fmt::format("{}: slow to fast", what), "slow to fast"};
    };
    const bool coloured_directions =
        job.look.show.has(Part::directions) && job.picture.colour != gl::VolumeColour::object;
    if (job.look.show.has(Part::arrows) || coloured_directions) {
        entries.push_back(flow("which way it went"));
    } else if (job.look.show.has(Part::tracelines)) {
        entries.push_back(flow("paths of the flow"));
    }
    return entries;
}

std::string span_of(const Caption& caption, const bricks::Volume& volume) {
    std::string text = fmt::format("{}, {}", counted(caption.frames, "frame"),
                                   labels::format_span(caption.begin, caption.end, caption.clock));
    double idle = 0;
    for (const bricks::CompressedIdle& stretch : bricks::compressed_stretches(volume)) idle += stretch.seconds;
    if (idle > 0) text += fmt::format(", {} without motion drawn short", labels::format_length(idle));
    return text;
}

/// A gap may be one of signal, or lie between the parts that were asked for.
std::vector<labels::TimeGap> explained_gaps(const video::FrameSpan& span, const bricks::Volume& volume) {
    std::vector<labels::TimeGap> gaps = labels::time_gaps(volume);
    if (span.parts.empty()) return gaps;
    constexpr double little = 1;  // seconds
    for (labels::TimeGap& gap : gaps) {
        double asked = 0;
        for (const video::FrameSpan::Part& part : span.parts) {
            asked += std::max(0.0, std::min(part.end, gap.end) - std::max(part.begin, gap.begin));
        }
        const bool left_out = gap.end - gap.begin - asked > little;
        if (left_out) gap.words = asked > little ? "left out, no signal" : "left out";
    }
    return gaps;
}

/// In the middle of the volume: an empty picture would look like a mistake.
void label_stillness(const Framing& framing, const image::Rgba& colour, labels::Lettering& lettering) {
    const PixelBox& box = framing.sheet.volume;
    lettering.add(labels::make_label_around("nothing moves", framing.sheet.text * 2, (box.left + box.right) / 2.0,
                                            (box.top + box.bottom) / 2.0, colour),
                  framing.sheet.between, 0);
}

// Only the default layout is an arc.
constexpr std::string_view along_arc = " along the arc,";
const std::array<std::string, 3> explanations{
    "Time runs along the arc, from left to right. Each cut through it is the camera's view at that moment. "
    "A number and its colour are the same object everywhere.",
    "Time runs along the arc, from left to right; each cut through it is the view at that moment.",
    "Time runs along the arc, from left to right."};

/// \param squeezed whether time is given room where something moves
void label_explanation(const space::LayoutRow& layout, bool squeezed, const labels::Sheet& sheet,
                       const image::Rgba& colour, labels::Lettering& lettering) {
    std::array<std::string, 3> texts = explanations;
    if (squeezed) {
        constexpr std::string_view direction = "from left to right";
        for (std::string& text : texts) {
            text.replace(text.find(direction), direction.size(), "from left to right, with room where something moves");
        }
    }
    if (&layout != &space::layouts().front()) {
        for (std::string& text : texts) text.replace(text.find(along_arc), along_arc.size(), "");
    }
    labels::add_first_that_fits(texts, sheet.small, sheet.explanation.left, sheet.explanation.bottom - sheet.small / 2,
                                sheet.explanation.inflated(0, sheet.small / 4), colour, lettering);
}

/// A frame at the end of the volume, with what it is and when above it.
void label_end(const std::string& what, const Plane<Bgr>& picture, double seconds, const PixelBox& box, bool right,
               const Caption& caption, const labels::Sheet& sheet, const image::Rgba& colour, const image::Rgba& border,
               labels::Lettering& lettering) {
    if (picture.empty() || box.empty()) return;
    lettering.pictures.push_back({box.inflated(-1, -1), picture, border, 1});
    const std::string text = fmt::format("{}, {}", what, labels::format_moment(seconds, caption.clock));
    labels::Label label = labels::make_label(text, sheet.small, box.left, box.top - sheet.small / 2, colour);
    if (right)
        label = labels::make_label(text, sheet.small, box.right - label.box.width(), box.top - sheet.small / 2, colour);
    lettering.labels.push_back(label);
}

/// Portraits, map, strip and frames beside the volume.
void label_glance(const RenderJob& job, const Caption& caption, const bricks::Volume& volume,
                  const space::Layout& layout, const Framing& framing, const Glance& glance,
                  labels::Lettering& lettering) {
    const Parts& show = job.look.show;
    const labels::Sheet& sheet = framing.sheet;
    const image::Rgba ink = rgba(job.look.theme.ink);
    const image::Rgba pale = rgba(job.look.theme.pale_ink);
    const image::Rgba lines = rgba(job.look.theme.lines);
    if (show.has(Part::explanation))
        label_explanation(*job.layout, !bricks::compressed_stretches(volume).empty(), sheet, pale, lettering);
    if (show.has(Part::ends)) {
        label_end("first frame", glance.first, caption.begin, sheet.first, false, caption, sheet, pale, lines,
                  lettering);
        label_end("last frame", glance.last, caption.end, sheet.last, true, caption, sheet, pale, lines, lettering);
    }
    const glance::Trails trails(volume, layout, framing.camera, sheet.picture);
    if (show.has(Part::map) && !glance.scene.empty()) {
        const double aspect = static_cast<double>(glance.field.width) / glance.field.height;
        const PixelBox box = glance::hollow_of(layout, framing.camera, sheet.picture, sheet.hollow, aspect);
        glance::draw_map(glance.objects, glance.scene, glance.field, box, sheet.small,
                         image::Rgba(background_of(job.look)), lettering);
    }
    if (show.has(Part::portraits) && glance.crops != nullptr) {
        glance::label_portraits(glance.objects, *glance.crops, trails, sheet, ink, pale, lettering);
    }
    if (show.has(Part::numbers)) {
        glance::label_numbers(glance.objects, trails, sheet, lettering);
        glance::label_stays(glance.objects, trails, sheet, image::Rgba(background_of(job.look)), lettering);
    }
    if (show.has(Part::strip)) {
        glance::label_strip(glance.objects, caption.begin, caption.end, caption.still, sheet,
                            {ink, pale, lines, image::Rgba(background_of(job.look))}, lettering);
    }
}

/// An event with that part of its path that lies in a stretch of time.
events::Event part_of(events::Event event, double begin, double end) {
    const auto outside = [&](const events::PathPoint& point) {
        return point.at.seconds < begin || point.at.seconds > end;
    };
    std::erase_if(event.path, outside);
    return event;
}

}  // namespace

glance::Objects shown_objects(const LookOptions& look, std::span<const events::Event> events, double begin, double end,
                              const WallClock& clock) {
    glance::Objects objects;
    objects.clock = clock;
    const std::vector<int> colours = events::colours_of(events);
    std::map<std::size_t, std::size_t> places;  // of those that are shown
    for (std::size_t k = 0; k < events.size(); ++k) {
        if (events[k].last.seconds < begin || events[k].first.seconds > end) continue;
        places[k] = objects.events.size();
        objects.events.push_back(part_of(events[k], begin, end));
        objects.numbers.push_back(k + 1);
        objects.colours.push_back(look.theme.objects[static_cast<std::size_t>(colours[k])]);
    }
    for (events::Event& event : objects.events) {
        for (std::optional<std::size_t>* const other : {&event.from, &event.into, &event.by}) {
            const auto place = *other ? places.find(**other) : places.end();
            *other = place == places.end() ? std::nullopt : std::optional(place->second);
        }
    }
    return objects;
}

Framing frame_volume(const RenderJob& job, const space::Layout& layout, double aspect) {
    Framing framing;
    const bool ruler = job.look.show.has(Part::ruler);
    const Parts& show = job.look.show;
    framing.sheet = labels::arrange_sheet(job.picture.size,
                                          {.title = show.has(Part::title),
                                           .ruler = ruler,
                                           .legend = show.has(Part::legend),
                                           .explanation = show.has(Part::explanation),
                                           .portraits = show.has(Part::portraits),
                                           .ends = show.has(Part::ends),
                                           .strip = show.has(Part::strip)},
                                          aspect);
    const PixelBox& part = framing.sheet.volume;
    std::vector<glm::dvec3> points = scene::outline_points(layout);
    if (job.look.show.any(&PartRow::around_volume)) points = scene::corners(scene::layout_bounds(layout));
    space::View view = job.picture.view;
    if (framing.sheet.text > 0) view.margin = 0.01;  // the sheet leaves room as it is
    space::Camera camera = space::fit_camera(view, points, part.size());
    framing.edge = labels::outer_edge(layout, camera, part.size());
    if (ruler) {
        const std::vector<glm::dvec3> reach = labels::ruler_reach(layout, framing.edge);
        points.insert(points.end(), reach.begin(), reach.end());
        camera = space::fit_camera(view, points, part.size());
    }
    framing.camera = camera.within(part, job.picture.size);
    return framing;
}

std::vector<labels::TimeTick> ticks_of(const RenderJob& job, const Framing& framing, const bricks::Volume& volume,
                                       const WallClock& clock) {
    if (!job.look.show.has(Part::ruler) || framing.sheet.text == 0 || volume.layers() == 0) return {};
    const int most = std::clamp(framing.sheet.picture.width / (8 * framing.sheet.text), 3, 11);
    if (volume.is_nonuniform()) return labels::spread_ticks(volume, most, clock);
    return labels::time_ticks(volume.layer(0).pts, volume.layer(volume.layers() - 1).last_pts, most, clock);
}

labels::Lettering letter(const RenderJob& job, const Caption& caption, const bricks::Volume& volume,
                         const space::Layout& layout, const Framing& framing,
                         const std::vector<labels::TimeTick>& ticks, const Glance& glance) {
    labels::Lettering lettering;
    lettering.font_missing = framing.sheet.text > 0 && !image::measure_text("0", framing.sheet.text);
    const image::Rgba ink = rgba(job.look.theme.ink);
    const image::Rgba pale = rgba(job.look.theme.pale_ink);
    const labels::Sheet& sheet = framing.sheet;
    const std::vector<labels::LegendEntry> legend =
        job.look.show.has(Part::legend) ? legend_of(job) : std::vector<labels::LegendEntry>{};
    const bool in_one_band = !legend.empty() && sheet.legend == sheet.title;
    const int right = sheet.title.right - (in_one_band ? labels::brief_width(legend, sheet) : 0);
    labels::label_title(caption.title, span_of(caption, volume), right, sheet, ink, pale, lettering);
    labels::label_legend(legend, sheet, pale, lettering);
    const bool ruler = job.look.show.has(Part::ruler) && framing.sheet.text > 0;
    if (ruler) {
        labels::label_gaps(explained_gaps(job.fields.span, volume), layout, framing.edge, framing.camera, framing.sheet,
                           rgba(job.look.theme.fast), lettering);
    }
    // Before the ticks: who reads a clock should know first where it leaps.
    if (ruler) {
        labels::label_breaks(labels::time_breaks(volume, breaks_shown), layout, framing.edge, framing.camera,
                             framing.sheet, pale, lettering);
    }
    labels::label_ruler(volume, layout, framing.edge, ticks, framing.camera, framing.sheet, ink, lettering);
    if (caption.still && framing.sheet.text > 0) label_stillness(framing, pale, lettering);
    if (framing.sheet.text > 0) label_glance(job, caption, volume, layout, framing, glance, lettering);
    return lettering;
}

}  // namespace vvr::app
