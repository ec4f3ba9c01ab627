// Table 1 of the paper: frames per second of its five styles at three picture sizes, on a left-bag volume of
// 384x288x1600 voxels. The styles are drawn in turn. JSON on stdout; scripts/bench makes a table of it.
//
//     table1 [FILTER] [BACKEND] [RUNS] [SCALE]
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/draw/draw.h"
#include "cli/plan/make_plan.h"
#include "cli/plan/settings.h"
#include "core/fields/field_source.h"
#include "gl/renderer.h"
#include "tests/bench/in_turn.h"
#include "tests/scene/scene.h"
#include "tests/scene/scene_source.h"

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

/// A part of a benchmark's work, for trying quickly whether all of it works: of a count, or of each side of a picture.
int scaled(int count, double scale) {
    return std::max(1, static_cast<int>(std::lround(scale * count)));
}

Size scaled(Size size, double scale) {
    return {scaled(size.width, scale), scaled(size.height, scale)};
}

/// A job that draws as the paper did: a sample per pixel, no text.
/// \param bricks of the window
app::RenderJob paper_job(Size size, int bricks, const app::Parts& show) {
    app::RenderJob job;
    job.bricks.window = bricks;
    job.look.show = show;
    job.picture.size = size;
    job.picture.samples = 1;
    return job;
}

/// Draws a volume again and again as `vvr render` draws it, in pieces that each have a texture.
class Drawing {
  public:
    /// \param context several drawings may share one
    /// \param volume outlives this
    Drawing(std::shared_ptr<gl::Context> context, const volume::Volume& volume, app::RenderJob job)
        : plan_(app::make_plan(std::move(job), {{}, volume.size(), volume.layers(), {}, {}, {}})),
          volume_(&volume),
          bricks_(volume::cut_into(volume.layers(), plan_.volume.bricks.window)),
          tiles_(gl::cut_tiles(plan_.look.picture.size, plan_.look.picture.tile_samples)) {
        session_.context = std::move(context);
        app::make_renderer(plan_.look, plan_.look.picture.tile_samples, session_);
        const auto textures = static_cast<int>(volume::cut_into_sub_bricks(bricks_).size());
        session_.window =
            std::make_unique<gl::BrickWindow>(session_.context->gl(), *plan_.look.layout, volume.layers(), textures);
        show();
        app::Composition composed;
        composed.framing = plan_.look.framing();
        session_.renderer->set_scene(app::scene_of(plan_, app::Observation{volume}, composed));
    }

    /// The next brick enters, the oldest leaves; after the last comes the first again.
    void push() {
        std::rotate(bricks_.begin(), bricks_.begin() + 1, bricks_.end());
        ++oldest_;
        show();
    }

    /// Draws and waits for the end of it, but reads nothing back: what a picture costs that stays on the GPU.
    void draw() {
        for (const PixelBox& tile : tiles_) session_.renderer->draw_tile(*session_.window, tile);
        session_.context->gl().Finish();
    }

  private:
    void show() {
        const std::int64_t pieces_of_brick = std::ssize(volume::cut_into_sub_bricks(std::array{bricks_.front()}));
        session_.window->show(*volume_, volume::cut_into_sub_bricks(bricks_), oldest_ * pieces_of_brick);
    }

    app::Plan plan_;
    const volume::Volume* volume_;
    std::vector<volume::Brick> bricks_;
    std::int64_t oldest_ = 0;  ///< number of the first brick of the window
    std::vector<PixelBox> tiles_;
    app::GlSession session_;
};

/// The volume of the left-bag scene seen through a filter, with the seeds and the flow that `vvr render` wants of it.
/// All layers are kept, as in the paper. \param scale of each side of it; less than 1 is for trying whether all works
volume::Volume left_bag_volume(const std::string& filter, double scale) {
    generator::Options scene;
    scene.frames = scaled(1600, scale);
    scene.size = scaled(scene.size, scale);
    media::SourceOptions in_colour{.colour = true};
    fields::FieldOptions options{.filter = filter};
    fields::ClipFields fields(generator::open_scene(generator::make_left_bag(scene), in_colour), options);
    const app::RenderJob job = paper_job({1, 1}, 1, {app::Part::volume, app::Part::arrows, app::Part::tracelines});
    const app::Plan plan = app::make_plan(job, {fields.info(), fields.field_size(), scene.frames, {}, {}, {}});
    const fields::FieldNeeds needs = app::needs_of(plan, fields, scene.frames);
    volume::Volume volume(fields.field_size(),
                          {.capacity = scene.frames, .step = 1, .seed_interval = needs.every, .keep_flow = true});
    fields.read(needs, [&](const media::SharedFrame&, const fields::Field& field) { volume.add(field); });
    return volume;
}

/// The share of the voxels that aren't 0.
double occupied_share(const volume::Volume& volume) {
    std::int64_t lit = 0;
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        volume.layer(i).scalar.for_each_run([&](int, int, std::span<const std::uint8_t> values) {
            lit += std::ranges::count_if(values, [](std::uint8_t value) { return value > 0; });
        });
    }
    const double voxels = 1.0 * volume.size().width * volume.size().height * static_cast<double>(volume.layers());
    return static_cast<double>(lit) / voxels;
}

std::vector<std::vector<double>> seconds_of_styles(const std::shared_ptr<gl::Context>& context,
                                                   const volume::Volume& volume, Size size, int runs) {
    std::vector<std::unique_ptr<Drawing>> drawings;
    std::vector<std::function<void()>> works;
    for (const Style& style : styles) {
        drawings.push_back(std::make_unique<Drawing>(context, volume, paper_job(size, style.bricks, style.show)));
        works.push_back([drawing = drawings.back().get(), moving = style.moving] {
            if (moving) drawing->push();
            drawing->draw();
        });
    }
    return bench::in_turn(works, runs);
}

nlohmann::json measure(const std::shared_ptr<gl::Context>& context, const std::string& filter, int runs, double scale) {
    const volume::Volume volume = left_bag_volume(filter, scale);
    nlohmann::json report{
        {"renderer", context->renderer()},    {"version", context->version()},  {"filter", filter},
        {"occupied", occupied_share(volume)}, {"seeds", volume.seeds().size()}, {"rows", nlohmann::json::array()}};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const Size size = scaled(sizes[i], scale);
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
