// The left-bag volume drawn as a straight box with one sample for each voxel along a ray, timed, and written for
// another program to draw alike (bench/vtk_volume.py): FOLDER gets volume.raw (x_C fastest, then y_C, then t_C),
// vvr.png, and scene.json with the camera, the colours and vvr's own seconds.
//
//     box_volume FOLDER [BACKEND] [RUNS]
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/image/picture_file.h"
#include "tests/bench/drawing.h"
#include "tests/bench/in_turn.h"
#include "tests/bench/left_bag.h"

namespace {

using namespace vvr;

nlohmann::json as_json(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

nlohmann::json colours(const scene::TransferFunction& transfer) {
    nlohmann::json table = nlohmann::json::array();
    for (int value = 0; value < 256; ++value) {
        const glm::dvec4 at = transfer.at(value);
        table.push_back({at.x, at.y, at.z, at.w});
    }
    return table;
}

void compare_box(const std::filesystem::path& folder, const std::string& backend, int runs) {
    const std::shared_ptr<gl::Context> context = gl::open_context(backend);
    const bricks::Volume volume = bench::left_bag_volume("difference");
    app::RenderJob job = bench::paper_job({800, 600}, 8);
    job.layout = "box";
    job.picture.view = {-20, 25, 30, 0.04};
    const double voxel = space::shape_for(volume.size()).y_s / volume.size().height;
    {
        bench::Drawing probe(context, volume, job);
        const scene::SliceStack stack = probe.renderer().slices(probe.window(), probe.renderer().camera());
        job.picture.slices = static_cast<int>(std::ceil(stack.count * stack.spacing / voxel));
    }
    bench::Drawing drawing(context, volume, job);
    gl::Renderer& renderer = drawing.renderer();
    image::write_picture(folder / "vvr.png", image::to_picture(renderer.draw(drawing.window())));
    const auto seconds = bench::in_turn({{{}, [&] { drawing.draw(); }}}, runs);

    std::vector<std::byte> raw;
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        // Against the image in both axes: from the last pixel to the first.
        for (int j = volume.size().height - 1; j >= 0; --j) {
            for (int k = volume.size().width - 1; k >= 0; --k)
                raw.push_back(std::byte{volume.layer(i).scalar.at(k, j)});
        }
    }
    replace_file(folder / "volume.raw", raw);

    const space::Camera& camera = renderer.camera();
    const glm::dvec3 far_corner = drawing.layout().p_from_c({1, 1, 1});
    const nlohmann::json scene{{"voxels", {volume.size().width, volume.size().height, volume.layers()}},
                               {"size", {job.picture.size.width, job.picture.size.height}},
                               {"low", as_json(drawing.layout().p_from_c({0, 0, 0}))},
                               {"high", as_json(far_corner)},
                               {"eye", as_json(camera.eye)},
                               {"forward", as_json(camera.forward)},
                               {"scale", camera.projection[1][1]},
                               {"shift", {camera.projection[2][0], camera.projection[2][1]}},
                               {"step", voxel},
                               {"slices", job.picture.slices},
                               {"colours", colours(scene::default_transfer_function())},
                               {"renderer", context->renderer()},
                               {"seconds", seconds.front()}};
    const std::string text = scene.dump();
    replace_file(folder / "scene.json", std::as_bytes(std::span(text)));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        fmt::print(stderr, "box_volume: it takes a folder to write to: box_volume FOLDER [BACKEND] [RUNS]\n");
        return 1;
    }
    try {
        compare_box(argv[1], argc > 2 ? argv[2] : "auto", argc > 3 ? std::stoi(argv[3]) : 5);
    } catch (const std::exception& error) {
        fmt::print(stderr, "box_volume: {}\n", error.what());
        return 1;
    }
}
