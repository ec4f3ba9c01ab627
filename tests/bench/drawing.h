#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/bricks/volume.h"
#include "core/space/layout.h"
#include "gl/renderer.h"

namespace vvr::bench {

/// A volume in a window of bricks and its renderer, one sample for each pixel, as the paper drew.
class Drawing {
  public:
    /// \param volume outlives this
    Drawing(const Context& context, const Volume& volume, const std::string& layout, int bricks, RenderOptions options)
        : gl_(&context.gl()),
          volume_(&volume),
          tiles_(cut_tiles(options.size, options.tile_samples)),
          bricks_(cut_into(volume.layers(), bricks)),
          layout_(make_layout(layout, shape_for(volume.size()))),
          renderer_(context, *layout_, with_one_sample(options)),
          window_(context.gl(), *layout_, volume.layers(), bricks) {
        renderer_.set_transfer(default_transfer_function());
        window_.show(volume, bricks_);
    }

    /// The next brick enters, the oldest leaves; after the last comes the first again.
    void push() {
        std::ranges::rotate(bricks_, bricks_.begin() + 1);
        window_.show(*volume_, bricks_, ++first_);
    }

    /// Draws and waits for the end of it, but reads nothing back: what a picture costs that stays on the GPU.
    void draw() {
        for (const PixelBox& tile : tiles_) renderer_.draw_tile(window_, tile);
        gl_->Finish();
    }

    const Layout& layout() const { return *layout_; }
    BrickWindow& window() { return window_; }
    Renderer& renderer() { return renderer_; }

  private:
    static RenderOptions with_one_sample(RenderOptions options) {
        options.samples = 1;
        return options;
    }

    const GladGLContext* gl_;
    const Volume* volume_;
    std::vector<PixelBox> tiles_;
    std::vector<Brick> bricks_;
    std::unique_ptr<Layout> layout_;
    Renderer renderer_;
    BrickWindow window_;
    std::int64_t first_ = 0;
};

}  // namespace vvr::bench
