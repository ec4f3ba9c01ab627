#include "core/space/layout.h"

#include "core/choice.h"

namespace vvr {

const std::vector<LayoutRow>& layouts() {
    static const std::vector<LayoutRow> table = {
        {"horseshoe", "the volume bent into a half circle, time from left to right (§5.1)", make_horseshoe},
        {"box", "the volume undistorted, time along x", make_box},
    };
    return table;
}

std::unique_ptr<Layout> make_layout(std::string_view name, const LayoutShape& shape) {
    return choose("layout", name, layouts()).make(shape);
}

LayoutShape shape_for(Size field, double r_min, double r_max) {
    return {r_min, r_max, (r_max - r_min) * field.height / field.width};
}

}  // namespace vvr
