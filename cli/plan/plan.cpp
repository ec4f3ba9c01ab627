#include "cli/plan/plan.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "core/scene/scene.h"
#include "core/volume/brick.h"

namespace vvr::app {

std::int64_t SlidingWindow::pieces_of_brick() const {
    return std::ssize(
        volume::cut_into_sub_bricks(volume::cut_at(std::array{volume::Brick{0, brick_layers}}, key_layers)));
}

std::int64_t planned_step(const BrickOptions& bricks, std::int64_t frames) {
    if (bricks.step > 0) return bricks.step;
    return std::max<std::int64_t>(1, (frames + bricks.max_layers - 1) / bricks.max_layers);
}

int VolumePlan::textures(int pieces) const {
    return std::max(1, drawn_again ? pieces : std::min(2, pieces));
}

Framing LookPlan::framing() const {
    Framing framing;
    framing.sheet = annotation::arrange_sheet(picture.size,
                                              {.title = shows(Part::title),
                                               .ruler = shows(Part::ruler),
                                               .legend = shows(Part::legend),
                                               .explanation = shows(Part::explanation),
                                               .portraits = shows(Part::portraits),
                                               .ends = shows(Part::ends),
                                               .stills = stills,
                                               .strip = shows(Part::strip),
                                               .large_captions = only_page},
                                              static_cast<double>(field.width) / field.height);
    const PixelBox& part = framing.sheet.volume;
    const std::vector<glm::dvec3> outline = scene::outline_points(*layout);
    std::vector<glm::dvec3> points =
        show.any(&PartRow::around_volume) ? scene::corners(scene::layout_bounds(*layout)) : outline;
    space::View view = picture.view;
    if (framing.sheet.text > 0) view.margin = sheet_margin;
    space::Camera camera = space::fit_camera(view, points, part.size());
    framing.edge = annotation::outer_edge(*layout, camera, part.size());
    if (shows(Part::ruler)) {
        const std::vector<glm::dvec3> reach = annotation::ruler_reach(*layout, framing.edge);
        points.insert(points.end(), reach.begin(), reach.end());
        camera = space::fit_camera(view, points, part.size());
    }
    framing.camera = camera.within(part, picture.size);
    double side = 0;
    for (const glm::dvec3& p : outline) side = std::max(side, framing.camera.pixel_size(p, picture.size));
    framing.half_pixel = side * std::numbers::sqrt2 / 2;
    return framing;
}

}  // namespace vvr::app
