// All text of a picture and its place.
#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/annotation/ruler.h"
#include "core/space/layout.h"
#include "tests/support/layouts.h"
#include "tests/unit/compose/observed.h"

namespace vvr {
namespace {

class OnASheet : public testing::TestWithParam<std::tuple<Size, std::string, std::pair<double, double>, int>> {};

// Strings and places: nothing overlaps, nothing leaves the picture, and each label of the ruler stands at its mark.
TEST_P(OnASheet, AllTextHasItsPlace) {
    const auto& [size, layout_name, eye, frames] = GetParam();
    const volume::Volume volume = test::even_volume({32, 24}, frames);
    const auto layout = space::make_layout(layout_name, space::shape_for(volume.size()));
    app::RenderJob job;
    job.layout = layout_name;
    job.picture.size = size;
    job.picture.view.azimuth = eye.first;
    job.picture.view.elevation = eye.second;
    job.look.title = "a clip with \"quotes\", <b> and umlauts äöü, whose name is long, longer, longest.avi";
    const app::Composition composed = test::composed_of(job, volume);
    const app::Framing& framing = composed.framing;
    const std::vector<annotation::TimeTick>& ticks = composed.ticks;
    const annotation::Lettering& lettering = composed.lettering;

    const PixelBox picture{0, 0, size.width, size.height};
    std::vector<PixelBox> boxes;
    for (const annotation::Label& label : lettering.labels) boxes.push_back(label.box);
    for (const annotation::ColourBar& bar : lettering.bars) boxes.push_back(bar.box);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_TRUE(picture.contains(boxes[i])) << i;
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(boxes[i].intersects(boxes[j])) << i << " " << j;
    }
    ASSERT_FALSE(lettering.labels.empty());
    EXPECT_TRUE(std::ranges::any_of(lettering.labels, [](const annotation::Label& label) {
        return label.text.starts_with("a clip with \"quotes\"");
    }));
    EXPECT_EQ(lettering.bars.size(), 2U) << "what the colours mean";

    int on_the_ruler = 0;
    for (const annotation::TimeTick& tick : ticks) {
        for (const annotation::Label& label : lettering.labels) {
            // The strip of times has texts of its own.
            if (label.text != tick.text || !framing.sheet.between.contains(label.box)) continue;
            ++on_the_ruler;
            const double t = volume.t_of_seconds(tick.seconds);
            const glm::dvec2 mark = framing.camera.pixel(layout->p_from_c({framing.edge.x, framing.edge.y, t}), size);
            const glm::dvec2 middle{(label.box.left + label.box.right) / 2.0, (label.box.top + label.box.bottom) / 2.0};
            EXPECT_LT(glm::distance(mark, middle), label.box.width() / 2.0 + 4.5 * framing.sheet.text) << tick.text;
        }
    }
    EXPECT_GE(on_the_ruler, 2);
    if (eye.second == 46) {
        EXPECT_EQ(on_the_ruler, static_cast<int>(ticks.size())) << "none is left out by default";
    }

    for (const glm::dvec3& corner : annotation::ruler_reach(*layout, framing.edge)) {
        const glm::dvec2 at = framing.camera.pixel(corner, size);
        EXPECT_TRUE(at.x >= 0 && at.x <= size.width && at.y >= 0 && at.y <= size.height);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Pictures, OnASheet,
    testing::Combine(testing::Values(Size{640, 480}, Size{1280, 800}, Size{3840, 2160}, Size{600, 1000}),
                     testing::ValuesIn(test::layout_names()),
                     testing::Values(std::pair{0.0, 46.0}, std::pair{40.0, 20.0}, std::pair{-120.0, -15.0}),
                     testing::Values(30, 2000)));

}  // namespace
}  // namespace vvr
