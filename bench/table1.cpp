// Table 1 of the paper: frames a second of the five styles at three picture sizes, on a left-bag volume of
// 384x288x1600. `table1 [BACKEND] [RUNS]`.

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/fields/pipeline.h"
#include "core/scene/glyph.h"
#include "gl/renderer.h"
#include "tests/scene/scene.h"
#include "tests/scene/scene_source.h"

namespace {

using namespace vvr;

constexpr int k = 8;

struct Style {
    std::string name;
    int bricks;
    bool geometry;
    bool moving;  ///< a brick enters before each picture
    std::array<double, 3> paper;
};

const std::vector<Style> styles = {
    {"V-S", 1, false, false, {11.04, 10.20, 8.64}}, {"V+S", k, false, false, {9.63, 7.83, 5.47}},
    {"V+S+G", k, true, false, {9.63, 7.83, 5.47}},  {"V+DS", k, false, true, {7.40, 6.80, 5.13}},
    {"all", k, true, true, {7.20, 6.65, 4.56}},
};

constexpr std::array<Size, 3> sizes = {Size{800, 600}, Size{1024, 768}, Size{1280, 1024}};

Volume left_bag_volume() {
    SourceOptions in_colour;
    in_colour.colour = true;
    const auto source = scene::open_scene(scene::make_left_bag(), in_colour);
    FieldOptions options;
    options.flow.every = 16;
    Volume volume(source->field_size(), 1600, 1, options.flow.every);
    compute_fields(*source, options, [&](Frame&&, Field&& field) { volume.add(field); });
    return volume;
}

void print_occupancy(const Volume& volume) {
    std::int64_t lit = 0;
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        lit += std::ranges::count_if(volume.layer(i).scalar.pixels(), [](std::uint8_t value) { return value > 0; });
    }
    const double voxels = 1.0 * volume.size().width * volume.size().height * static_cast<double>(volume.layers());
    fmt::print("volume {}x{}x{}, {:.2f} % of the voxels are not empty, {} seeds\n", volume.size().width,
               volume.size().height, volume.layers(), 100 * static_cast<double>(lit) / voxels, volume.seeds().size());
}

double median_seconds(int runs, const std::function<void()>& draw) {
    draw();
    std::vector<double> seconds;
    for (int i = 0; i < runs; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        draw();
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    std::ranges::nth_element(seconds, seconds.begin() + runs / 2);
    return seconds[static_cast<std::size_t>(runs) / 2];
}

double frames_a_second(const Context& context, const Volume& volume, const Style& style, Size size, int runs) {
    const auto layout = make_layout("horseshoe", shape_for(volume.size()));
    const std::vector<Brick> bricks = cut_into(volume.layers(), style.bricks);
    RenderOptions options;
    options.size = size;
    options.samples = 1;
    options.ring = style.bricks;
    options.window_layers = volume.layers();
    Renderer renderer(context, *layout, options);
    renderer.set_transfer(default_transfer_function());
    std::vector<BrickTexels> texels;
    for (const Brick& brick : bricks) texels.push_back(brick_texels(volume, brick));
    std::int64_t next = 0;
    const auto push = [&] {
        renderer.push_brick(next, texels[static_cast<std::size_t>(next) % texels.size()]);
        ++next;
    };
    for (std::size_t i = 0; i < bricks.size(); ++i) push();
    Scene scene;
    if (style.geometry) scene.arrows = arrows(volume, *layout, {});
    renderer.set_scene(scene);
    return 1 / median_seconds(runs, [&] {
               if (style.moving) push();
               renderer.draw_unread();
           });
}

}  // namespace

int main(int argc, char** argv) {
    const auto context = open_context(argc > 1 ? argv[1] : "auto");
    const int runs = argc > 2 ? std::stoi(argv[2]) : 5;
    const Volume volume = left_bag_volume();
    fmt::print("{}\n", context->renderer());
    print_occupancy(volume);
    fmt::print("{:8}", "fps");
    for (const Size size : sizes) fmt::print("{:>12}  (paper)", fmt::format("{}x{}", size.width, size.height));
    fmt::print("\n");
    for (const Style& style : styles) {
        fmt::print("{:8}", style.name);
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            fmt::print("{:12.2f}  {:7.2f}", frames_a_second(*context, volume, style, sizes[i], runs), style.paper[i]);
            std::fflush(stdout);
        }
        fmt::print("\n");
    }
}
