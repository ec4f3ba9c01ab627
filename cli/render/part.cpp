#include "cli/render/part.h"

#include <algorithm>
#include <array>

namespace vvr {

namespace {

constexpr std::array table{
    PartRow{.part = Part::volume, .name = "volume", .help = "what moved or is new, over time", .by_default = true},
    PartRow{.part = Part::arrows,
            .name = "arrows",
            .help = "which way things go, and how fast",
            .by_default = true,
            .needs_seeds = true},
    PartRow{.part = Part::tracelines,
            .name = "tracelines",
            .help = "the paths that the flow carries points along",
            .needs_seeds = true,
            .needs_flow = true},
    PartRow{.part = Part::outline, .name = "outline", .help = "the edges of the volume", .by_default = true},
    PartRow{.part = Part::frames,
            .name = "frames",
            .help = "the first and the last frame, and key frames between them",
            .by_default = true,
            .needs_pictures = true},
    PartRow{.part = Part::floor, .name = "floor", .help = "the shadow of the volume on the floor", .by_default = true},
    PartRow{.part = Part::ruler, .name = "ruler", .help = "times along the outer edge", .by_default = true},
    PartRow{.part = Part::legend,
            .name = "legend",
            .help = "what the colours mean",
            .by_default = true,
            .tells_objects = true},
    PartRow{.part = Part::title, .name = "title", .help = "name and length of the clip", .by_default = true},
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

}  // namespace vvr
