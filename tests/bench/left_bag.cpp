#include "tests/bench/left_bag.h"

#include <algorithm>

#include "core/fields/field_source.h"
#include "tests/bench/drawing.h"
#include "tests/bench/scale.h"
#include "tests/scene/scene.h"
#include "tests/scene/scene_source.h"

namespace vvr::bench {

Volume left_bag_volume(const std::string& filter, double scale) {
    scene::Options scene;
    scene.frames = scaled(1600, scale);
    scene.size = scaled(scene.size, scale);
    SourceOptions in_colour;
    in_colour.colour = true;
    FieldOptions options;
    options.filter = filter;
    ClipFields fields(scene::open_scene(scene::make_left_bag(scene), in_colour), options);
    const RenderJob job = paper_job({}, 1, {Part::volume, Part::arrows, Part::tracelines});
    const FieldNeeds needs = needs_of(job, fields, scene.frames);
    Volume volume(fields.field_size(), scene.frames, 1, needs.every);
    volume.keep_flow();
    fields.read(needs, [&](const SharedFrame&, const Field& field) { volume.add(field); });
    return volume;
}

double occupied_share(const Volume& volume) {
    std::int64_t lit = 0;
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        volume.layer(i).scalar.each_run([&](int, int, std::span<const std::uint8_t> values) {
            lit += std::ranges::count_if(values, [](std::uint8_t value) { return value > 0; });
        });
    }
    const double voxels = 1.0 * volume.size().width * volume.size().height * static_cast<double>(volume.layers());
    return static_cast<double>(lit) / voxels;
}

}  // namespace vvr::bench
