#include <chrono>

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/option.h"
#include "cli/options_output.h"
#include "cli/plan.h"
#include "cli/progress.h"
#include "cli/render_job.h"
#include "core/bricks/volume.h"
#include "core/fields/filter.h"
#include "core/fields/pipeline.h"
#include "core/image/picture_file.h"
#include "core/scene/scene.h"
#include "gl/renderer.h"

namespace vvr {

namespace {

/// Reads the clip once and gathers its fields; the caller's log says what it found.
Volume build_volume(const RenderJob& job, FrameSource& source, const Environment& environment) {
    const Plan plan = make_plan(job, source);
    const bool bar = !job.run.quiet && stderr_is_terminal();
    Volume volume(source.field_size(), window_layers(job.bricks, source.info().rate), job.input.step);
    FieldSummary summary;
    {
        Progress progress("frames", plan.frames, bar);
        summary = compute_fields(source, job.fields, [&](Frame&&, Field&& field) {
            volume.add(field);
            progress.set(volume.frames());
        });
    }
    if (summary.damaged > 0) {
        environment.log.warn("'{}': {} damaged packets; the picture shows the {} frames that decode",
                             source.info().name, summary.damaged, summary.frames);
    }
    if (volume.step() > job.input.step) {
        environment.log.info("the clip is longer than the window: {} frames share a layer", volume.step());
    }
    return volume;
}

Scene build_scene(const RenderJob& job, const Volume& volume, const Layout& layout) {
    Scene scene;
    GlyphOptions glyphs;
    glyphs.frames *= job.look.glyph_scale;
    glyphs.cap *= job.look.glyph_scale;
    if (job.look.shows("arrows")) scene.arrows = arrows(volume, layout, glyphs);
    if (job.look.shows("outline")) scene.outline = volume_outline(layout, {0.35F, 0.38F, 0.42F, 1});
    return scene;
}

Plane<glm::vec4> draw(const RenderJob& job, const Volume& volume, double rate, const Context& context) {
    const auto layout = make_layout(job.view, volume.size());
    const std::vector<Brick> bricks = cut(job.bricks, volume.layers(), rate);
    RenderOptions options;
    options.size = job.view.size;
    options.view = view_of(job.view);
    options.slices = job.view.slices;
    options.ring = static_cast<int>(bricks.size());
    options.window_layers = volume.layers();
    options.glyphs.thickness *= static_cast<float>(job.look.glyph_scale);
    Renderer renderer(context, *layout, options);
    renderer.set_transfer(default_transfer_function().scaled(job.look.shows("volume") ? job.look.opacity : 0));
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        renderer.push_brick(static_cast<std::int64_t>(i), brick_texels(volume, bricks[i]));
    }
    return renderer.draw(build_scene(job, volume, *layout));
}

Picture as_picture(const Plane<glm::vec4>& drawn) {
    Picture picture{Plane<Rgba>(drawn.size())};
    std::ranges::transform(drawn.pixels(), picture.pixels.pixels().begin(), [](const glm::vec4& value) {
        return Rgba{value.r, value.g, value.b, value.a};
    });
    return picture;
}

/// The settings that made the picture, and what they made of this clip.
Metadata describe(const CommandLine& line, const Volume& volume, const Context& context) {
    Metadata metadata;
    for (const char* name : {group::input, group::fields, group::bricks, group::view, group::look}) {
        for (auto& [option, value] : line.settings(name)) {
            // A picture that is passed on should not tell where its maker keeps files.
            if (option == "reference") value = std::filesystem::path(value).filename().string();
            metadata.emplace_back(option, std::move(value));
        }
    }
    metadata.emplace_back("frames", fmt::to_string(volume.frames()));
    metadata.emplace_back("layers", fmt::to_string(volume.layers()));
    metadata.emplace_back("renderer", context.renderer());
    return metadata;
}

}  // namespace

ExitStatus run_render(const Command& command, Arguments arguments, const Environment& environment) {
    RenderJob job;
    OutputOptions output;
    CommandLine line(command.name, command.help);
    add_options(line.app(), output);
    add_options(line.app(), job);
    if (!line.parse(arguments)) return ExitStatus::done;
    apply(job.run, environment.log);
    check(job);
    check(output);

    // Whatever can fail without reading the clip fails first.
    {
        const auto held = environment.signals.hold();
        check_picture_path(output.path);
    }
    if (!job.look.shows("arrows")) job.fields.flow.method = "none";
    const bool colour = find_filter(job.fields.filter).needs.colour;
    const auto source = open_clip(job.input, colour, job.run.threads);
    const auto context = open_context(job.backend.backend, job.backend.device);
    environment.log.debug("backend {}: {}, OpenGL {}", context->backend(), context->renderer(), context->version());

    job.fields.threads = job.run.threads;
    const auto begin = std::chrono::steady_clock::now();
    const Volume volume = build_volume(job, *source, environment);
    const Picture picture = as_picture(draw(job, volume, source->info().rate, *context));
    const Metadata metadata = describe(line, volume, *context);
    {
        const auto held = environment.signals.hold();
        write_picture(output.path, picture, metadata);
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    environment.log.info("'{}': {} frames in {} layers, {:.1f} s", output.path.string(), volume.frames(),
                         volume.layers(), took.count());
    return ExitStatus::done;
}

}  // namespace vvr
