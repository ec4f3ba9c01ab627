#include "gl/brick_window.h"

#include <utility>

#include <oneapi/tbb/parallel_for.h>

namespace vvr::gl {

BrickWindow::BrickWindow(const GladGLContext& gl, const space::Layout& layout, std::int64_t layers, int textures,
                         double margin)
    : layout_(&layout), window_layers_(static_cast<double>(layers)), margin_(margin), textures_(gl, textures) {}

void BrickWindow::show(const bricks::Volume& volume, std::span<const bricks::Brick> bricks, std::int64_t first,
                       const bricks::Identify& identify) {
    std::vector<Shown> before = std::exchange(shown_, {});
    for (const bricks::Brick& brick : bricks)
        shown_.push_back({first + std::ssize(shown_), bricks::BrickLayers(volume, brick, identify), {}});

    // The same brick as it was shown before, if it has the same neighbours as then.
    const auto unchanged = [&](std::size_t i) -> Shown* {
        const std::int64_t was = before.empty() ? -1 : shown_[i].number - before.front().number;
        if (was < 0 || was >= std::ssize(before)) return nullptr;
        const bool same_before = (was == 0) == (i == 0);
        const bool same_after = (was + 1 == std::ssize(before)) == (i + 1 == shown_.size());
        return same_before && same_after ? &before[static_cast<std::size_t>(was)] : nullptr;
    };
    oneapi::tbb::parallel_for(std::size_t{0}, shown_.size(), [&](std::size_t i) {
        const bricks::BrickLayers& layers = shown_[i].layers;
        Shown* const was = unchanged(i);
        shown_[i].cells =
            was != nullptr ? std::move(was->cells) : bricks::brick_cells(layers, t_span(layers), *layout_, margin_);
    });

    textures_.keep_only(first, first + std::ssize(shown_));
    placed_.clear();
    std::int64_t layers_before = 0;
    for (std::size_t i = 0; i < shown_.size(); ++i) {
        const auto& [number, layers, cells] = shown_[i];
        if (unchanged(i) == nullptr) textures_.update_border_layers(number, layers);
        const double t_begin = static_cast<double>(layers_before) / window_layers_;
        layers_before += layers.brick().count;
        placed_.push_back({&cells, t_begin, static_cast<double>(layers_before) / window_layers_});
    }
}

double BrickWindow::t_span(const bricks::BrickLayers& layers) const {
    return static_cast<double>(layers.brick().count) / window_layers_;
}

TextureMap BrickWindow::texture_map(std::size_t i) const {
    const bricks::BrickLayers& brick = layers(i);
    const auto count = static_cast<double>(brick.brick().count);
    // The texture has a layer more at each end than the brick.
    const double t_scale = count / (count + 2) / (placed_[i].t_end - placed_[i].t_begin);
    const double width = brick.box().width();
    const double height = brick.box().height();
    return {{brick.size().width / width, brick.size().height / height, t_scale},
            {-brick.box().left / width, -brick.box().top / height, 1 / (count + 2) - placed_[i].t_begin * t_scale}};
}

}  // namespace vvr::gl
