// How the time and the memory of a picture grow: over its pixels, the number of bricks, the pixels of a frame, and how
// much of the volume is occupied. Each row of one series is drawn in turn with the others. JSON on stdout;
// scripts/bench makes plots of it.
//
//     growth [BACKEND] [RUNS] [SCALE]
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/bench/drawing.h"
#include "tests/bench/in_turn.h"
#include "tests/bench/left_bag.h"
#include "tests/bench/lit_volume.h"
#include "tests/bench/memory.h"
#include "tests/bench/scale.h"

namespace {

using namespace vvr;

/// What one point of a curve draws.
struct Point {
    double x;
    const bricks::Volume* volume;
    int bricks;
    Size size;
};

bench::Drawing drawing_of(const std::shared_ptr<gl::Context>& context, const Point& point) {
    return {context, *point.volume, bench::paper_job(point.size, point.bricks)};
}

/// What the renderer holds to draw a point and read its picture back, beside the volume itself.
double megabytes_of(const std::shared_ptr<gl::Context>& context, const Point& point) {
    const bench::PeakMemory peak;
    bench::Drawing drawing = drawing_of(context, point);
    drawing.renderer().draw(drawing.window());
    return peak.megabytes();
}

nlohmann::json measure(const std::shared_ptr<gl::Context>& context, const std::vector<Point>& points, int runs) {
    std::vector<double> megabytes;
    for (const Point& point : points) megabytes.push_back(megabytes_of(context, point));
    std::vector<std::unique_ptr<bench::Drawing>> drawings;
    std::vector<bench::Work> works;
    for (const Point& point : points) {
        drawings.push_back(std::make_unique<bench::Drawing>(drawing_of(context, point)));
        works.push_back({{}, [drawing = drawings.back().get()] { drawing->draw(); }});
    }
    const auto seconds = bench::in_turn(works, runs);
    nlohmann::json curve = nlohmann::json::array();
    for (std::size_t i = 0; i < points.size(); ++i) {
        curve.push_back({{"x", points[i].x}, {"seconds", seconds[i]}, {"megabytes", megabytes[i]}});
    }
    return curve;
}

nlohmann::json measure_all(const std::shared_ptr<gl::Context>& context, int runs, double scale) {
    const int frames = bench::scaled(1600, scale);
    const Size common_size = bench::scaled(Size{800, 600}, scale);
    const bricks::Volume bag = bench::left_bag_volume("difference", scale);
    std::vector<Point> pixels;
    for (const int width : {640, 896, 1280, 1792, 2560}) {
        const Size size = bench::scaled(Size{width, width * 3 / 4}, scale);
        pixels.push_back({1e-6 * size.width * size.height, &bag, 8, size});
    }
    std::vector<Point> bricks;
    for (const int k : {1, 2, 4, 8, 16, 32}) bricks.push_back({static_cast<double>(k), &bag, k, common_size});

    std::vector<bricks::Volume> coarse_to_fine;
    for (const int width : {96, 192, 288, 384, 576}) {
        coarse_to_fine.push_back(bench::lit_volume(bench::scaled(Size{width, width * 3 / 4}, scale), frames / 4, 0.1));
    }
    std::vector<Point> voxels;
    for (const bricks::Volume& volume : coarse_to_fine) {
        voxels.push_back({1e-3 * volume.size().width * volume.size().height, &volume, 8, common_size});
    }

    const std::vector<double> shares{0, 0.125, 0.25, 0.5, 0.75, 1};
    std::vector<bricks::Volume> lit;
    const Size coarse = bench::scaled(Size{192, 144}, scale);
    for (const double share : shares) lit.push_back(bench::lit_volume(coarse, frames / 2, share));
    std::vector<Point> occupied;
    for (std::size_t i = 0; i < shares.size(); ++i) occupied.push_back({shares[i], &lit[i], 8, common_size});

    return {{"renderer", context->renderer()},          {"version", context->version()},
            {"pixels", measure(context, pixels, runs)}, {"bricks", measure(context, bricks, runs)},
            {"voxels", measure(context, voxels, runs)}, {"occupied", measure(context, occupied, runs)}};
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::shared_ptr<gl::Context> context = gl::open_context(argc > 1 ? argv[1] : "auto");
        const int runs = argc > 2 ? std::stoi(argv[2]) : 5;
        const double scale = argc > 3 ? std::stod(argv[3]) : 1;
        fmt::print("{}\n", measure_all(context, runs, scale).dump());
    } catch (const std::exception& error) {
        fmt::print(stderr, "growth: {}\n", error.what());
        return 1;
    }
}
