#include "tests/bench/drawing.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vvr::bench {

app::RenderJob paper_job(Size size, int bricks, const app::Parts& show) {
    app::RenderJob job;
    job.bricks.window = bricks;
    job.look.show = show;
    job.picture.size = size;
    job.picture.samples = 1;
    return job;
}

Drawing::Drawing(std::shared_ptr<gl::Context> context, const bricks::Volume& volume, app::RenderJob job)
    : plan_(app::make_plan(std::move(job), {{}, volume.size(), volume.layers(), {}, {}, {}})),
      volume_(&volume),
      bricks_(bricks::cut_into(volume.layers(), plan_.job.bricks.window)),
      tiles_(gl::cut_tiles(plan_.picture.size, plan_.picture.tile_samples)) {
    drawing_.context = std::move(context);
    app::make_renderer(plan_, plan_.picture.tile_samples, drawing_);
    const int textures =
        app::textures_of({.series = true}, static_cast<int>(bricks::cut_into_sub_bricks(bricks_).size()));
    drawing_.window = std::make_unique<gl::BrickWindow>(drawing_.context->gl(), layout(), volume.layers(), textures);
    show();
    app::Composition composed;
    composed.framing = plan_.framing();
    renderer().set_scene(app::scene_of(plan_, app::Observation{volume}, composed));
}

void Drawing::push() {
    std::rotate(bricks_.begin(), bricks_.begin() + 1, bricks_.end());
    ++oldest_;
    show();
}

void Drawing::draw() {
    for (const PixelBox& tile : tiles_) renderer().draw_tile(window(), tile);
    drawing_.context->gl().Finish();
}

void Drawing::show() {
    const std::int64_t pieces_of_brick = std::ssize(bricks::cut_into_sub_bricks(std::array{bricks_.front()}));
    window().show(*volume_, bricks::cut_into_sub_bricks(bricks_), oldest_ * pieces_of_brick);
}

}  // namespace vvr::bench
