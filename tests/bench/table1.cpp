// Table 1 of the paper: frames per second of its five styles at three picture sizes, on a left-bag volume of
// 384x288x1600 voxels. The styles are drawn in turn. JSON on stdout; scripts/bench makes a table of it.
//
//     table1 [FILTER] [BACKEND] [RUNS] [SCALE]
#include <array>
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
#include "tests/bench/scale.h"

namespace {

using namespace vvr;

constexpr int k = 8;

struct Style {
    const char* name;
    int bricks;
    app::Parts show;
    bool moving;                  ///< a brick enters before each picture
    std::array<double, 3> paper;  ///< on a GeForce 7800 GTX
};

const std::array styles = {
    Style{"V-S", 1, {app::Part::volume}, false, {11.04, 10.20, 8.64}},
    Style{"V+S", k, {app::Part::volume}, false, {9.63, 7.83, 5.47}},
    Style{"V+S+G", k, {app::Part::volume, app::Part::arrows}, false, {9.63, 7.83, 5.47}},
    Style{"V+DS", k, {app::Part::volume}, true, {7.40, 6.80, 5.13}},
    Style{"all", k, {app::Part::volume, app::Part::arrows, app::Part::tracelines}, true, {7.20, 6.65, 4.56}},
};

constexpr std::array sizes = {Size{800, 600}, Size{1024, 768}, Size{1280, 1024}};

std::vector<std::vector<double>> seconds_of_styles(const std::shared_ptr<gl::Context>& context,
                                                   const bricks::Volume& volume, Size size, int runs) {
    std::vector<std::unique_ptr<bench::Drawing>> drawings;
    std::vector<bench::Work> works;
    for (const Style& style : styles) {
        drawings.push_back(
            std::make_unique<bench::Drawing>(context, volume, bench::paper_job(size, style.bricks, style.show)));
        works.push_back({{}, [drawing = drawings.back().get(), moving = style.moving] {
                             if (moving) drawing->push();
                             drawing->draw();
                         }});
    }
    return bench::in_turn(works, runs);
}

nlohmann::json measure(const std::shared_ptr<gl::Context>& context, const std::string& filter, int runs, double scale) {
    const bricks::Volume volume = bench::left_bag_volume(filter, scale);
    nlohmann::json report{{"renderer", context->renderer()},
                          {"version", context->version()},
                          {"filter", filter},
                          {"occupied", bench::occupied_share(volume)},
                          {"seeds", volume.seeds().size()},
                          {"rows", nlohmann::json::array()}};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const Size size = bench::scaled(sizes[i], scale);
        const auto seconds = seconds_of_styles(context, volume, size, runs);
        for (std::size_t s = 0; s < styles.size(); ++s) {
            report["rows"].push_back({{"style", styles[s].name},
                                      {"width", size.width},
                                      {"height", size.height},
                                      {"paper_fps", styles[s].paper[i]},
                                      {"seconds", seconds[s]}});
        }
    }
    return report;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::shared_ptr<gl::Context> context = gl::open_context(argc > 2 ? argv[2] : "auto");
        const int runs = argc > 3 ? std::stoi(argv[3]) : 5;
        const double scale = argc > 4 ? std::stod(argv[4]) : 1;
        fmt::print("{}\n", measure(context, argc > 1 ? argv[1] : "difference", runs, scale).dump());
    } catch (const std::exception& error) {
        fmt::print(stderr, "table1: {}\n", error.what());
        return 1;
    }
}
