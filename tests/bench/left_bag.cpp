#include "tests/bench/left_bag.h"

#include <algorithm>

#include "core/fields/field_source.h"
#include "tests/bench/drawing.h"
#include "tests/bench/scale.h"
#include "tests/scene/scene.h"
#include "tests/scene/scene_source.h"

namespace vvr::bench {

bricks::Volume left_bag_volume(const std::string& filter, double scale) {
    generator::Options scene;
    scene.frames = scaled(1600, scale);
    scene.size = scaled(scene.size, scale);
    video::SourceOptions in_colour;
    in_colour.colour = true;
    fields::FieldOptions options;
    options.filter = filter;
    fields::ClipFields fields(generator::open_scene(generator::make_left_bag(scene), in_colour), options);
    const app::RenderJob job = paper_job({1, 1}, 1, {app::Part::volume, app::Part::arrows, app::Part::tracelines});
    const app::Plan plan = app::make_plan(job, {fields.info(), fields.field_size(), scene.frames, {}, {}, {}});
    const fields::FieldNeeds needs = app::needs_of(plan, fields, scene.frames);
    bricks::Volume volume(fields.field_size(),
                          {.capacity = scene.frames, .step = 1, .seed_interval = needs.every, .keep_flow = true});
    fields.read(needs, [&](const video::SharedFrame&, const fields::Field& field) { volume.add(field); });
    return volume;
}

double occupied_share(const bricks::Volume& volume) {
    std::int64_t lit = 0;
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        volume.layer(i).scalar.for_each_run([&](int, int, std::span<const std::uint8_t> values) {
            lit += std::ranges::count_if(values, [](std::uint8_t value) { return value > 0; });
        });
    }
    const double voxels = 1.0 * volume.size().width * volume.size().height * static_cast<double>(volume.layers());
    return static_cast<double>(lit) / voxels;
}

}  // namespace vvr::bench
