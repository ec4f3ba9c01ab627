#include "cli/render/annotate.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/fields/filter.h"
#include "core/labels/legend.h"
#include "core/scene/overlay.h"
#include "core/scene/slices.h"
#include "core/scene/transfer_file.h"
#include "core/words.h"

namespace vvr {

namespace {

Rgba rgba(const glm::vec3& colour) {
    return {colour.x, colour.y, colour.z, 1};
}

std::vector<Rgba> gradient(const glm::vec3& from, const glm::vec3& to) {
    constexpr int steps = 64;
    std::vector<Rgba> colours;
    for (int i = 0; i < steps; ++i) colours.push_back(rgba(glm::mix(from, to, static_cast<float>(i) / (steps - 1))));
    return colours;
}

/// What a thing as thick as a person's track looks like, by its value.
std::vector<Rgba> transfer_gradient(const TransferFunction& transfer, int low, const glm::vec4& background) {
    std::vector<Rgba> colours;
    for (int value = low; value < 256; ++value) {
        const glm::dvec4 at = transfer.at(value);
        const auto opacity = static_cast<float>(1 - std::exp(-at.w * opacity_length * 2));
        const glm::vec4 colour = glm::vec4(glm::vec3(at) * opacity, opacity) + background * (1 - opacity);
        colours.push_back({colour.x, colour.y, colour.z, colour.w});
    }
    return colours;
}

int first_visible(const TransferFunction& transfer) {
    int value = 0;
    while (value < 255 && !transfer.visible({0, static_cast<std::uint8_t>(value)})) ++value;
    return value;
}

std::vector<LegendEntry> legend_of(const RenderJob& job) {
    std::vector<LegendEntry> entries;
    if (job.look.show.has(Part::volume) && job.picture.colour == VolumeColour::transfer) {
        const TransferFunction transfer = transfer_of(job.look);
        const int low = first_visible(transfer);
        const FilterRow& filter = find_filter(job.fields.filter);
        entries.push_back({transfer_gradient(drawn_transfer_of(job.look), low, background_of(job.look)),
                           fmt::format("{}, {} to 255", filter.help, low),
                           fmt::format("{} {} to 255", filter.name, low)});
    }
    const GlyphStyle style = glyph_style_of(job);
    const auto flow = [&](const std::string& what) {
        return LegendEntry{
            gradient(style.slow_colour, style.fast_colour),
            fmt::format("{}, {:g} to {:g} pixels per frame", what, style.speed_range.x, style.speed_range.y),
            fmt::format("speed {:g} to {:g} px/frame", style.speed_range.x, style.speed_range.y)};
    };
    if (job.look.show.has(Part::arrows)) {
        entries.push_back(flow("which way it goes"));
    } else if (job.look.show.has(Part::tracelines)) {
        entries.push_back(flow("paths of the flow"));
    }
    return entries;
}

std::string span_of(const Caption& caption, const Volume& volume) {
    std::string text =
        fmt::format("{}, {}", counted(caption.frames, "frame"), format_span(caption.begin, caption.end, caption.clock));
    if (volume.left_out() > 0) text += fmt::format(", {} without motion left out", format_length(volume.left_out()));
    return text;
}

/// In the middle of the volume: an empty picture would look like a mistake.
void letter_stillness(const Framing& framing, const Rgba& colour, Lettering& lettering) {
    const PixelBox& box = framing.sheet.volume;
    lettering.add(make_label_around("nothing moves", framing.sheet.text * 2, (box.left + box.right) / 2.0,
                                    (box.top + box.bottom) / 2.0, colour),
                  framing.sheet.between, 0);
}

}  // namespace

Framing frame_volume(const RenderJob& job, const Layout& layout) {
    Framing framing;
    const bool ruler = job.look.show.has(Part::ruler);
    framing.sheet =
        arrange_sheet(job.picture.size, {job.look.show.has(Part::title), ruler, job.look.show.has(Part::legend)});
    const PixelBox& part = framing.sheet.volume;
    std::vector<glm::dvec3> points = outline_points(layout);
    if (job.look.show.any(&PartRow::around_volume)) points = corners(layout_box(layout));
    View view = job.picture.view;
    if (framing.sheet.text > 0) view.margin = 0.01;  // the sheet leaves room as it is
    Camera camera = fit_camera(view, points, part.size());
    framing.edge = outer_edge(layout, camera, part.size());
    if (ruler) {
        const std::vector<glm::dvec3> reach = ruler_reach(layout, framing.edge);
        points.insert(points.end(), reach.begin(), reach.end());
        camera = fit_camera(view, points, part.size());
    }
    framing.camera = camera.within(part, job.picture.size);
    return framing;
}

std::vector<TimeTick> ticks_of(const RenderJob& job, const Framing& framing, const Volume& volume,
                               const WallClock& clock) {
    if (!job.look.show.has(Part::ruler) || framing.sheet.text == 0 || volume.layers() == 0) return {};
    const int most = std::clamp(framing.sheet.picture.width / (8 * framing.sheet.text), 3, 11);
    if (volume.left_out() > 0) return spread_ticks(volume, most, clock);
    return time_ticks(volume.layer(0).pts, volume.layer(volume.layers() - 1).last_pts, most, clock);
}

Lettering letter(const RenderJob& job, const Caption& caption, const Volume& volume, const Layout& layout,
                 const Framing& framing, const std::vector<TimeTick>& ticks) {
    Lettering lettering;
    lettering.font_missing = framing.sheet.text > 0 && !measure_text("0", framing.sheet.text);
    const Rgba ink = rgba(job.look.theme.ink);
    const Rgba pale = rgba(job.look.theme.pale_ink);
    letter_title(caption.title, span_of(caption, volume), framing.sheet, ink, pale, lettering);
    if (job.look.show.has(Part::legend)) letter_legend(legend_of(job), framing.sheet, pale, lettering);
    const bool ruler = job.look.show.has(Part::ruler) && framing.sheet.text > 0;
    if (ruler) {
        letter_gaps(time_gaps(volume), layout, framing.edge, framing.camera, framing.sheet, rgba(job.look.theme.fast),
                    lettering);
    }
    letter_ruler(volume, layout, framing.edge, ticks, framing.camera, framing.sheet, ink, lettering);
    if (ruler) {
        letter_breaks(time_breaks(volume, breaks_shown), layout, framing.edge, framing.camera, framing.sheet, pale,
                      lettering);
    }
    if (caption.still && framing.sheet.text > 0) letter_stillness(framing, pale, lettering);
    return lettering;
}

}  // namespace vvr
