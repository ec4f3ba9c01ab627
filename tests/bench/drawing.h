#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/bricks/volume.h"
#include "core/space/layout.h"
#include "gl/renderer.h"

namespace vvr::bench {

/// A renderer with the whole of a volume in it, one sample a pixel, as the paper drew.
class Drawing {
  public:
    /// \param volume outlives this
    Drawing(const Context& context, const Volume& volume, const std::string& layout, int bricks, RenderOptions options)
        : layout_(make_layout(layout, shape_for(volume.size()))),
          renderer_(context, *layout_, complete(options, volume, bricks)) {
        renderer_.set_transfer(default_transfer_function());
        for (const Brick& brick : cut_into(volume.layers(), bricks)) {
            bricks_.emplace_back(volume, brick);
            renderer_.push_brick(next_++, bricks_.back());
        }
    }

    /// The next brick enters, the oldest leaves; after the last comes the first again.
    void push() {
        renderer_.push_brick(next_, bricks_[static_cast<std::size_t>(next_) % bricks_.size()]);
        ++next_;
    }

    const Layout& layout() const { return *layout_; }
    Renderer& renderer() { return renderer_; }

  private:
    static RenderOptions complete(RenderOptions options, const Volume& volume, int bricks) {
        options.samples = 1;
        options.ring = bricks;
        options.window_layers = volume.layers();
        return options;
    }

    std::unique_ptr<Layout> layout_;
    Renderer renderer_;
    std::vector<BrickLayers> bricks_;
    std::int64_t next_ = 0;
};

}  // namespace vvr::bench
