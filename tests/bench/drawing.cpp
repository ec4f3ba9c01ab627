#include "tests/bench/drawing.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vvr::bench {

RenderJob paper_job(Size size, int bricks, const Parts& show) {
    RenderJob job;
    job.bricks.window = bricks;
    job.look.show = show;
    job.picture.size = size;
    job.picture.samples = 1;
    return job;
}

Drawing::Drawing(std::shared_ptr<Context> context, const Volume& volume, RenderJob job)
    : job_(std::move(job)),
      volume_(&volume),
      bricks_(cut_into(volume.layers(), job_.bricks.window)),
      tiles_(cut_tiles(job_.picture.size, job_.picture.tile_samples)) {
    drawing_.context = std::move(context);
    make_renderer(job_, volume.size(), job_.picture.tile_samples, drawing_);
    const int textures = textures_of({.series = true}, static_cast<int>(cut_into_pieces(bricks_).size()));
    drawing_.window = std::make_unique<BrickWindow>(drawing_.context->gl(), layout(), volume.layers(), textures);
    show();
    const Frame none;
    Scene scene = build_scene(job_, volume, {none, none}, layout(), drawing_.framing, {}, {});
    add_overlays(job_, drawing_, bricks_, volume.layers(), scene);
    renderer().set_scene(std::move(scene));
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
    const std::int64_t pieces_of_brick = std::ssize(cut_into_pieces(std::array{bricks_.front()}));
    window().show(*volume_, cut_into_pieces(bricks_), oldest_ * pieces_of_brick);
}

}  // namespace vvr::bench
