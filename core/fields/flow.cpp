#include "core/fields/flow.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <utility>

#include "core/base/setting.h"
#include "core/fields/blobs.h"

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

constexpr std::int64_t few_frames = 64;

// Parts that cover more than this share cost more, with their margins, than the whole picture.
constexpr double max_share = 0.7;

bool intersect(const Rect& a, const Rect& b) {
    return a.x < b.x + b.size.width && b.x < a.x + a.size.width && a.y < b.y + b.size.height &&
           b.y < a.y + a.size.height;
}

Rect bounding_rect(const Rect& a, const Rect& b) {
    const int x = std::min(a.x, b.x);
    const int y = std::min(a.y, b.y);
    return {
        x,
        y,
        {std::max(a.x + a.size.width, b.x + b.size.width) - x, std::max(a.y + a.size.height, b.y + b.size.height) - y}};
}

long area(const Rect& r) {
    return static_cast<long>(r.size.width) * r.size.height;
}

Rect inflated(const Rect& r, int margin, Size size) {
    const int x = std::max(r.x - margin, 0);
    const int y = std::max(r.y - margin, 0);
    return {x,
            y,
            {std::min(r.x + r.size.width + margin, size.width) - x,
             std::min(r.y + r.size.height + margin, size.height) - y}};
}

/// Adds a part, merged with all parts that it touches, and with those that the merged one then touches.
void add(std::vector<Rect>& parts, Rect part) {
    for (std::size_t k = 0; k < parts.size();) {
        if (!intersect(parts[k], part)) {
            ++k;
            continue;
        }
        part = bounding_rect(parts[k], part);
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
        k = 0;
    }
    parts.push_back(part);
}

}  // namespace

std::vector<Rect> regions_around(const Plane<std::uint8_t>& object, int margin) {
    const Size size = object.size();
    std::vector<Rect> parts;
    const Plane<std::uint8_t> tiles = occupied_tiles(object);
    for (int y = 0; y < tiles.height(); ++y) {
        for (int x = 0; x < tiles.width(); ++x) {
            if (tiles.at(x, y) == 0) continue;
            add(parts, inflated({x * tile_side, y * tile_side, {tile_side, tile_side}}, margin, size));
        }
    }
    long covered = 0;
    for (const Rect& part : parts) covered += area(part);
    const Rect whole{0, 0, size};
    if (static_cast<double>(covered) > max_share * static_cast<double>(area(whole))) return {whole};
    return parts;
}

bool is_short(std::int64_t frames) {
    return frames > 0 && frames <= few_frames;
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

bool FlowChoice::is_folder() const {
    return row_ == &of_folder;
}

}  // namespace vvr::fields
