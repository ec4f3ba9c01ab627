#include "cli/app/framing.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "core/scene/scene.h"

namespace vvr::app {

Framing frame_volume(const RenderJob& job, const space::Layout& layout, Size field_size) {
    Framing framing;
    const Parts& show = job.look.show;
    framing.sheet = labels::arrange_sheet(job.picture.size,
                                          {.title = show.has(Part::title),
                                           .ruler = show.has(Part::ruler),
                                           .legend = show.has(Part::legend),
                                           .explanation = show.has(Part::explanation),
                                           .portraits = show.has(Part::portraits),
                                           .ends = show.has(Part::ends),
                                           .strip = show.has(Part::strip)},
                                          static_cast<double>(field_size.width) / field_size.height);
    const PixelBox& part = framing.sheet.volume;
    const std::vector<glm::dvec3> outline = scene::outline_points(layout);
    std::vector<glm::dvec3> points =
        show.any(&PartRow::around_volume) ? scene::corners(scene::layout_bounds(layout)) : outline;
    space::View view = job.picture.view;
    if (framing.sheet.text > 0) view.margin = 0.01;  // the sheet already leaves a margin
    space::Camera camera = space::fit_camera(view, points, part.size());
    framing.edge = labels::outer_edge(layout, camera, part.size());
    if (show.has(Part::ruler)) {
        const std::vector<glm::dvec3> reach = labels::ruler_reach(layout, framing.edge);
        points.insert(points.end(), reach.begin(), reach.end());
        camera = space::fit_camera(view, points, part.size());
    }
    framing.camera = camera.within(part, job.picture.size);
    double side = 0;
    for (const glm::dvec3& p : outline) side = std::max(side, framing.camera.pixel_size(p, job.picture.size));
    framing.half_pixel = side * std::numbers::sqrt2 / 2;
    return framing;
}

}  // namespace vvr::app
