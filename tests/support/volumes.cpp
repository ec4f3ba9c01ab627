#include "tests/support/volumes.h"

#include <cmath>

#include "tests/support/fields.h"
#include "tests/support/planes.h"

namespace vvr::test {

volume::Volume full_volume(Size size, int layers) {
    return even_volume(size, layers, 255);
}

volume::Volume wandering_balls(Size size, int layers) {
    volume::Volume volume(size, {std::max(layers, 2)});
    for (int f = 0; f < layers; ++f) {
        Plane<std::uint8_t> scalar(size);
        for (int ball = 0; ball < 3; ++ball) {
            const double phase = 2.1 * ball;
            const double cx = size.width * (0.5 + 0.35 * std::sin(phase + 5.0 * f / layers));
            const double cy = size.height * (0.55 + 0.25 * std::cos(2 * phase + 3.0 * f / layers));
            const double radius = size.height * (0.10 + 0.03 * ball);
            for (int j = 0; j < size.height; ++j) {
                for (int i = 0; i < size.width; ++i) {
                    const double away = std::hypot(i - cx, j - cy) / radius;
                    if (away >= 1) continue;
                    const double value = 255 * (1 - away * away);
                    std::uint8_t& pixel = scalar.at(i, j);
                    pixel = std::max(pixel, static_cast<std::uint8_t>(value));
                }
            }
        }
        volume.add(field_of(f, std::move(scalar)));
    }
    return volume;
}

Plane<std::uint8_t> whole(const volume::SparsePlane& sparse) {
    return plane_of<std::uint8_t>(sparse.size(), [&](int i, int j) { return sparse.at(i, j); });
}

Drawn draw_volume(const volume::Volume& volume, Shot shot) {
    const auto layout = space::make_layout(shot.layout, space::shape_for(volume.size()));
    const auto context = gl::open_context(shot.backend);
    gl::Renderer renderer(*context, *layout, shot.options);
    renderer.set_transfer(shot.transfer);
    renderer.set_scene(std::move(shot.scene));
    gl::BrickWindow window(context->gl(), *layout, volume.layers(), 2);
    window.show(volume, volume::cut_into(volume.layers(), shot.bricks));
    return {renderer.draw(window), renderer.camera()};
}

}  // namespace vvr::test
