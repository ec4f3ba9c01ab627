#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "cli/app/draw.h"
#include "cli/app/job.h"
#include "cli/app/plan.h"
#include "core/bricks/volume.h"
#include "gl/renderer.h"

namespace vvr::bench {

/// A job that draws as the paper did: a sample per pixel, no text.
/// \param bricks of the window
app::RenderJob paper_job(Size size, int bricks, const app::Parts& show = {app::Part::volume});

/// Draws a volume again and again as `vvr render` draws it, in pieces that each have a texture.
class Drawing {
  public:
    /// \param context several drawings may share one
    /// \param volume outlives this
    Drawing(std::shared_ptr<gl::Context> context, const bricks::Volume& volume, app::RenderJob job);

    /// The next brick enters, the oldest leaves; after the last comes the first again.
    void push();

    /// Draws and waits for the end of it, but reads nothing back: what a picture costs that stays on the GPU.
    void draw();

    const space::Layout& layout() const { return *plan_.layout; }
    gl::BrickWindow& window() { return *drawing_.window; }
    gl::Renderer& renderer() { return *drawing_.renderer; }

  private:
    void show();

    app::Plan plan_;
    const bricks::Volume* volume_;
    std::vector<bricks::Brick> bricks_;
    std::int64_t oldest_ = 0;  ///< number of the first brick of the window
    std::vector<PixelBox> tiles_;
    vvr::app::Drawing drawing_;
};

}  // namespace vvr::bench
