#include "cli/options/render_settings.h"

#include "cli/options/option.h"
#include "cli/options/presets.h"
#include "core/error.h"
#include "core/fields/filter.h"
#include "core/fields/pipeline.h"

namespace vvr {

void add_options(CLI::App& app, RenderSettings& settings) {
    add_options(app, settings.input);
    add_integer(app, group::input, settings.input.step, 0, 1'000'000,
                {"--step", "FRAMES", "", "frames that share a layer; 0 = as few as the window allows"});
    add_options(app, settings.fields);
    add_text(app, group::fields, settings.seeds,
             {"--seeds", "DIR", "", "lists of seeds, as `vvr extract` writes them, instead of computed ones"});
    add_options(app, settings.bricks);
    add_options(app, settings.view);
    add_options(app, settings.look);
    add_choice(app, group::look, settings.preset, presets(),
               {"--preset", "NAME", "", "options for a purpose; those that stand beside it win"});
    add_options(app, settings.run);
    add_options(app, settings.backend);
}

void check(const RenderSettings& settings, bool series) {
    if (settings.input.names.size() < 2) only_input(settings.input);
    span_of(settings.input);
    check(settings.bricks, series);
    if (series && settings.look.keyframes > 0) {
        throw Error(
            ErrorKind::usage,
            "--keyframes is for one picture of a clip; the pictures of a series show their first and last frame");
    }
    validate(settings.fields);
}

bool wants_colour(const RenderSettings& settings) {
    // Where an object is looked for, colour counts: not only if the picture happens to show some.
    return find_filter(settings.fields.filter).traits.colour || needs_reference(settings.fields) ||
           settings.look.shows("frames") || settings.look.volume_colour() == VolumeColour::video;
}

RenderJob job_for(const RenderSettings& settings) {
    RenderJob job;
    job.step = settings.input.step;

    job.bricks = settings.bricks.count.value_or(standard_window);
    if (const auto& brick = settings.bricks.length) {
        if (brick->unit == Time::Unit::seconds) job.brick_seconds = brick->value;
        if (brick->unit == Time::Unit::frames) job.brick_frames = static_cast<std::int64_t>(brick->value);
    }

    job.layout = settings.view.layout;
    job.shape.r_min = settings.view.radii.first;
    job.shape.r_max = settings.view.radii.second;
    job.shape.height = settings.view.height.value_or(0);
    job.picture.size = settings.view.size;
    job.picture.view = view_of(settings.view);
    job.slice_view = slice_view_of(settings.view);
    job.picture.slices = settings.view.slices;
    job.picture.samples = settings.view.samples;

    job.show = {settings.look.show.begin(), settings.look.show.end()};
    job.picture.colour = settings.look.volume_colour();
    job.picture.shading = settings.look.volume_shading();
    job.theme = find_theme(settings.look.theme);
    job.picture.background = settings.look.background_colour();
    job.picture.glyphs.slow_colour = job.theme.slow;
    job.picture.glyphs.fast_colour = job.theme.fast;
    job.title = settings.look.title;
    job.keyframes = settings.look.keyframes;
    const FilterRow& filter = find_filter(settings.fields.filter);
    job.scalar = {std::string(filter.name), std::string(filter.help)};
    job.transfer =
        find_transfer(settings.look.transfer.empty() ? std::string(job.theme.transfer) : settings.look.transfer);
    job.opacity = settings.look.opacity;
    job.traces = settings.look.traces;
    job.glyphs.time_velocity = settings.look.traces.time_velocity;
    job.glyphs.frames *= settings.look.glyph_scale;
    job.glyphs.cap *= settings.look.glyph_scale;
    job.picture.glyphs.thickness *= static_cast<float>(settings.look.glyph_scale);

    job.backend = settings.backend.backend;
    job.device = settings.backend.device;
    return job;
}

}  // namespace vvr
