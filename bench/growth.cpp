// How the time of a picture grows: over its pixels, the number of bricks, and how much of the volume is occupied. Each
// row of one series is drawn in turn with the others. JSON on stdout; scripts/bench makes plots of it.
//
//     growth [BACKEND] [RUNS]
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/drawing.h"
#include "bench/in_turn.h"
#include "bench/left_bag.h"

namespace {

using namespace vvr;

constexpr Size common_size{800, 600};

/// What one point of a curve draws.
struct Point {
    double x;
    const Volume* volume;
    int bricks;
    Size size;
};

nlohmann::json measure(const Context& context, const std::vector<Point>& points, int runs) {
    std::vector<std::unique_ptr<bench::Drawing>> drawings;
    std::vector<bench::Work> works;
    for (const Point& point : points) {
        RenderOptions options;
        options.size = point.size;
        drawings.push_back(
            std::make_unique<bench::Drawing>(context, *point.volume, "horseshoe", point.bricks, options));
        works.push_back({{}, [drawing = drawings.back().get()] { drawing->renderer().draw_unread(); }});
    }
    const auto seconds = bench::in_turn(works, runs);
    nlohmann::json curve = nlohmann::json::array();
    for (std::size_t i = 0; i < points.size(); ++i) curve.push_back({{"x", points[i].x}, {"seconds", seconds[i]}});
    return curve;
}

/// A volume of which the left part of each frame is lit.
Volume lit_volume(double share) {
    constexpr Size size{192, 144};
    constexpr int frames = 800;
    Volume volume(size, frames);
    Plane<std::uint8_t> scalar(size);
    for (int j = 0; j < size.height; ++j) {
        std::ranges::fill(scalar.row(j).first(static_cast<std::size_t>(share * size.width)), std::uint8_t{160});
    }
    for (int i = 0; i < frames; ++i) {
        Field field;
        field.index = i;
        field.pts = i / 25.0;
        field.scalar = scalar;
        volume.add(field);
    }
    return volume;
}

}  // namespace

int main(int argc, char** argv) {
    const auto context = open_context(argc > 1 ? argv[1] : "auto");
    const int runs = argc > 2 ? std::stoi(argv[2]) : 5;
    const Volume bag = bench::left_bag_volume("difference");

    std::vector<Point> pixels;
    for (const int width : {640, 896, 1280, 1792, 2560}) {
        const Size size{width, width * 3 / 4};
        pixels.push_back({1e-6 * size.width * size.height, &bag, 8, size});
    }
    std::vector<Point> bricks;
    for (const int k : {1, 2, 4, 8, 16, 32}) bricks.push_back({static_cast<double>(k), &bag, k, common_size});
    std::vector<Volume> lit;
    std::vector<Point> occupied;
    const std::vector<double> shares{0, 0.125, 0.25, 0.5, 0.75, 1};
    for (const double share : shares) lit.push_back(lit_volume(share));
    for (std::size_t i = 0; i < shares.size(); ++i) occupied.push_back({shares[i], &lit[i], 8, common_size});

    const nlohmann::json report{{"renderer", context->renderer()},
                                {"pixels", measure(*context, pixels, runs)},
                                {"bricks", measure(*context, bricks, runs)},
                                {"occupied", measure(*context, occupied, runs)}};
    fmt::print("{}\n", report.dump());
}
