// Polygons of --roi and --mask.
#include "core/fields/region.h"

#include <algorithm>

#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    const std::string text(fuzz::text_of(data, size));
    if (!fields::is_polygon_list(text)) return 0;
    const bool good = fuzz::parsed([&] {
                          fields::validate_region("roi", text);
                          return true;
                      }).has_value();
    fields::FieldOptions options;
    options.roi = text;
    const auto region = fuzz::parsed([&] { return fields::make_region(options, {48, 36}, {640, 480}); });
    fuzz::require(region.has_value() == good, "what was checked can be drawn");
    if (!region) return 0;
    fuzz::require(region->size() == Size{48, 36}, "the region has the field's size");
    fuzz::require(std::ranges::all_of(region->pixels(), [](auto p) { return p == 0 || p == 255; }), "in or out");
    return 0;
}
