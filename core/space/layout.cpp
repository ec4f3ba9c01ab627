#include "core/space/layout.h"

namespace vvr::space {

const std::vector<LayoutRow>& layouts() {
    static const std::vector<LayoutRow> table = {
        {"horseshoe", "the volume bent into a half circle, time from left to right (§5.1)", make_horseshoe},
        {"box", "the volume undistorted, time along x", make_box},
    };
    return table;
}

std::unique_ptr<Layout> make_layout(const Choice<LayoutRow>& row, const LayoutShape& shape) {
    return row->make(shape);
}

LayoutShape shape_for(Size field, const LayoutOptions& options) {
    const double square = (options.r_max - options.r_min) * field.height / field.width;
    return {options.r_min, options.r_max, options.height > 0 ? options.height : square};
}

std::vector<int> sections_towards(double t, std::span<const double> borders) {
    const int n = static_cast<int>(borders.size()) - 1;
    int split = 0;
    while (split < n - 1 && borders[static_cast<std::size_t>(split) + 1] <= t) ++split;
    std::vector<int> order;
    for (int i = 0; i < split; ++i) order.push_back(i);
    for (int i = n - 1; i >= split; --i) order.push_back(i);
    return order;
}

const LayoutRow& row_of(Name<LayoutRow> name) {
    return choose("layout", name.text, layouts());
}

}  // namespace vvr::space
