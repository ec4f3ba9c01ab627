#include "core/fields/flow.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "core/base/setting.h"
#include "core/fields/blobs.h"
#include "core/fields/thresholds.h"

namespace vvr::fields {
namespace {

constexpr std::array flow_rows{
    FlowRow{"horn-schunck", "the paper's method; --solver solves its equations", make_horn_schunck},
    FlowRow{"dis", "OpenCV's dense inverse search", make_dis},
    FlowRow{"farneback", "OpenCV's polynomial expansion", make_farneback},
    FlowRow{"none", "no flow and no seeds", [](const FlowOptions&) { return std::unique_ptr<FlowMethod>{}; }, true},
};

/// Chosen by the name of a folder.
constexpr FlowRow of_folder{"folder", "the .flo files of a folder", make_stored_flow};

long area(const PixelBox& box) {
    return static_cast<long>(box.width()) * box.height();
}

/// Adds a part, merged with all parts that it touches, and with those that the merged one then touches.
void add(std::vector<PixelBox>& parts, PixelBox part) {
    for (std::size_t k = 0; k < parts.size();) {
        if (!parts[k].intersects(part)) {
            ++k;
            continue;
        }
        part = bounding_box(parts[k], part);
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
        k = 0;
    }
    parts.push_back(part);
}

}  // namespace

std::vector<PixelBox> regions_around(const Plane<std::uint8_t>& object, int margin) {
    const PixelBox whole{0, 0, object.width(), object.height()};
    std::vector<PixelBox> parts;
    const Plane<std::uint8_t> tiles = occupied_tiles(object);
    for (int y = 0; y < tiles.height(); ++y) {
        for (int x = 0; x < tiles.width(); ++x) {
            if (tiles.at(x, y) == 0) continue;
            const PixelBox tile{x * tile_side, y * tile_side, (x + 1) * tile_side, (y + 1) * tile_side};
            add(parts, intersection(tile.inflated(margin, margin), whole));
        }
    }
    long covered = 0;
    for (const PixelBox& part : parts) covered += area(part);
    if (static_cast<double>(covered) > thresholds.flow.most_parts * static_cast<double>(area(whole))) return {whole};
    return parts;
}

bool is_short(std::int64_t frames) {
    return frames > 0 && frames <= thresholds.flow.few_frames;
}

bool has_flow(const FlowOptions& options) {
    return !options.method.row().is_none;
}

const FlowRow& no_flow() {
    return *std::ranges::find_if(flow_rows, &FlowRow::is_none);
}

std::span<const FlowRow> flow_methods() {
    return flow_rows;
}

std::unique_ptr<FlowMethod> make_flow(const FlowOptions& options) {
    return options.method.row().make(options);
}

FlowChoice::FlowChoice(std::string name) : name_(std::move(name)), row_(&of_folder) {
    // A folder's name is checked only when its files are needed.
    const auto* const row = std::ranges::find(flow_rows, name_, &FlowRow::name);
    if (row != flow_rows.end()) {
        row_ = row;
    } else if (name_.find_first_of("./") == std::string::npos && !std::filesystem::exists(name_)) {
        refuse_choice("flow", name_, names_of(flow_rows), ", or the name of a folder of .flo files");
    }
}

FlowChoice::FlowChoice(const FlowRow& row) : name_(row.name), row_(&row) {}

FlowChoice FlowChoice::none() {
    return FlowChoice(no_flow());
}

bool FlowChoice::is_folder() const {
    return row_ == &of_folder;
}

}  // namespace vvr::fields
