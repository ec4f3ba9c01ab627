#include <array>

#include "core/base/setting.h"
#include "core/fields/filter.h"

namespace vvr::fields {
namespace {

constexpr std::array rows{
    FilterRow{"difference",
              "what differs from the empty scene",
              {.object = true, .colour = true, .shows_object = true, .threshold = 24},
              make_difference},
    FilterRow{"temporal",
              "what differs from the frame before",
              {.colour = true, .previous = true, .threshold = 16, .gain = 2},
              make_temporal},
    FilterRow{"hull",
              "the silhouette of what differs from the empty scene: over time, its visual hull",
              {.object = true, .colour = true, .shows_object = true, .threshold = 24},
              make_hull},
    FilterRow{"bands",
              "the silhouette in three bands: uncovered 85, still covered 170, newly covered 255",
              {.object = true,
               .colour = true,
               .previous = true,
               .shows_object = true,
               .values = Values::band,
               .threshold = 24},
              make_bands,
              "bands"},
    FilterRow{
        "signed",
        "what differs from the empty scene, darker 127 to 1, brighter 129 to 255",
        {.object = true, .colour = true, .shows_object = true, .darker = true, .values = Values::sign, .threshold = 24},
        make_signed,
        "signed"},
    FilterRow{"edges", "how steeply the brightness changes", {.min_area = false, .threshold = 24}, make_edges},
    FilterRow{"flow",
              "how fast it moves: 24 levels for a pixel a frame",
              {.flow = true, .threshold = 12},
              make_flow_magnitude},
    FilterRow{"luminance", "the video itself", {.min_area = false}, make_luminance},
    FilterRow{"mog2",
              "OpenCV's background model of Gaussian mixtures",
              {.colour = true, .in_order = true, .shows_object = true},
              make_mog2},
    FilterRow{"knn",
              "OpenCV's background model of nearest neighbours",
              {.colour = true, .in_order = true, .shows_object = true},
              make_knn},
};

}  // namespace

std::span<const FilterRow> filters() {
    return rows;
}

const FilterRow& row_of(Name<FilterRow> name) {
    return choose("filter", name.text, filters());
}

}  // namespace vvr::fields
