// Polygons of --roi and --mask.
#include "core/fields/region.h"

#include <algorithm>

#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view input) {
    const std::string text(input);
    if (!fields::is_polygon_list(text)) return;
    const bool good = parsed([&] {
                          fields::validate_region("roi", text);
                          return true;
                      }).has_value();
    fields::FieldOptions options{.roi = text};
    const auto region = parsed([&] { return fields::make_region(options, {48, 36}, {640, 480}); });
    require(region.has_value() == good, "what was checked can be drawn");
    if (!region) return;
    require(region->size() == Size{48, 36}, "the region has the field's size");
    require(std::ranges::all_of(region->pixels(), [](auto p) { return p == 0 || p == 255; }), "in or out");
}
