#include "cli/plan/look.h"

#include <algorithm>
#include <array>

#include "core/fields/filter.h"

namespace vvr::app {

namespace {

constexpr std::array table{
    PartRow{.part = Part::volume, .name = "volume", .help = "what moved or is new, over time", .by_default = true},
    PartRow{.part = Part::portraits,
            .name = "portraits",
            .help = "stills of the most important objects, each at its best moment",
            .by_default = true,
            .needs_pictures = true,
            .needs_events = true},
    PartRow{.part = Part::map,
            .name = "map",
            .help = "the empty scene with the path of each object",
            .by_default = true,
            .needs_pictures = true,
            .needs_events = true},
    PartRow{.part = Part::strip,
            .name = "strip",
            .help = "when each object was there, as bars over an even axis of time",
            .by_default = true,
            .needs_events = true,
            .page_has_own = true},
    PartRow{.part = Part::numbers,
            .name = "numbers",
            .help = "the number of each object, where its trail begins",
            .by_default = true,
            .needs_events = true},
    PartRow{.part = Part::directions,
            .name = "directions",
            .help = "arrows along the trails: direction and speed of each object",
            .needs_events = true},
    PartRow{.part = Part::arrows,
            .name = "arrows",
            .help = "the optical flow at the seeds: direction and speed",
            .needs_seeds = true},
    PartRow{.part = Part::tracelines,
            .name = "tracelines",
            .help = "the paths of points that follow the flow from the seeds",
            .needs_seeds = true,
            .needs_flow = true},
    PartRow{.part = Part::outline, .name = "outline", .help = "the edges of the volume", .by_default = true},
    PartRow{.part = Part::ribs,
            .name = "ribs",
            .help = "cuts through the volume at the times of the ruler",
            .by_default = true},
    PartRow{.part = Part::frames,
            .name = "frames",
            .help = "the first and the last frame at their places in the volume, and key frames between them",
            .by_default = true,
            .needs_pictures = true},
    PartRow{
        .part = Part::ends,
        .name = "ends",
        .help =
            "the first and the last frame, undistorted; in a tall picture with the moments between them that tell most",
        .by_default = true,
        .needs_pictures = true,
        .page_has_own = true},
    PartRow{.part = Part::floor, .name = "floor", .help = "the shadow of the volume on the floor"},
    PartRow{.part = Part::ruler, .name = "ruler", .help = "times along the outer edge", .by_default = true},
    PartRow{.part = Part::legend,
            .name = "legend",
            .help = "what the colours mean",
            .by_default = true,
            .page_has_own = true},
    PartRow{.part = Part::title,
            .name = "title",
            .help = "name and length of the clip",
            .by_default = true,
            .page_has_own = true},
    PartRow{.part = Part::explanation,
            .name = "explanation",
            .help = "a line that says how to read the picture",
            .by_default = true,
            .page_has_own = true},
    PartRow{.part = Part::bricks, .name = "bricks", .help = "the borders between bricks"},
    PartRow{.part = Part::boxes,
            .name = "boxes",
            .help = "the boxes around the volume and around what is visible of it (Fig. 5)",
            .around_volume = true},
    PartRow{.part = Part::slices,
            .name = "slices",
            .help = "some of the slices that draw the volume (Fig. 5)",
            .around_volume = true},
};

}  // namespace

std::span<const PartRow> parts() {
    return table;
}

Parts Parts::by_default() {
    Parts parts;
    for (const PartRow& row : table) {
        if (row.by_default) parts.add(row.part);
    }
    return parts;
}

bool Parts::any(bool PartRow::*trait) const {
    return std::ranges::any_of(table, [&](const PartRow& row) { return row.*trait && has(row.part); });
}

namespace {

std::vector<ColourRow> make_rows() {
    std::vector<ColourRow> rows{
        {"auto",
         "object if a part that describes objects is shown, the filter marks objects, and no transfer function is "
         "given; else transfer"},
        {"object", "a colour for each object; everything else is faint grey", gl::VolumeColour::object},
        {"transfer", "the filter's values, through the transfer function"},
        {"video", "the colours of the video", gl::VolumeColour::own, true},
        {"direction", "the direction of motion, on a wheel of colours; grey at rest", gl::VolumeColour::own, false,
         true, true},
        {"speed", "the speed of motion, in the colours of the arrows", gl::VolumeColour::own, false, true},
        {"time", "the time, from the first moment to the last", gl::VolumeColour::time},
    };
    for (const fields::FilterRow& filter : fields::filters()) {
        if (filter.traits.given) continue;
        const std::string name(filter.name);
        rows.push_back({name, "a second filter's values: " + std::string(filter.help), gl::VolumeColour::own, false,
                        false, false, &filter});
    }
    return rows;
}

}  // namespace

const std::vector<ColourRow>& colour_rows() {
    static const std::vector<ColourRow> rows = make_rows();
    return rows;
}

const ColourRow& row_of(Name<ColourRow> name) {
    return choose("color", name.text, colour_rows());
}

}  // namespace vvr::app
